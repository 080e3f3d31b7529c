#pragma once

#include <gtest/gtest.h>

#include <string>

#include "mote/operators/kernels/all.hpp"

namespace mote::test {

/// One kernel of the list in one dimension.
template <template <int> class K, int D>
struct KernelCase {
  using Kernel = K<D>;
  static constexpr int dimension = D;
};

template <class List>
struct CasesOf;

template <template <int> class... K>
struct CasesOf<KernelList<K...>> {
  using type = testing::Types<KernelCase<K, 1>..., KernelCase<K, 2>..., KernelCase<K, 3>...>;
};

/// Every kernel of mote in every dimension.
using KernelCases = CasesOf<Kernels>::type;

/// The kernels that operators are tested on: all, but under the sanitizers, which look at memory
/// and not at values, one that reaches far, one in pieces, and one with formulas for lanes.
#ifdef MOTE_SANITIZED
using OperatorKernels = KernelList<Gauss, CubicSpline, WendlandC2>;
#else
using OperatorKernels = Kernels;
#endif
using OperatorKernelCases = CasesOf<OperatorKernels>::type;

struct KernelCaseName {
  template <class Case>
  static std::string GetName(int) {
    return std::string(Case::Kernel::name) + "_" + std::to_string(Case::dimension) + "d";
  }
};

}  // namespace mote::test
