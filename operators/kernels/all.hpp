#pragma once

#include "mote/operators/kernels/cubic_spline.hpp"
#include "mote/operators/kernels/gauss.hpp"
#include "mote/operators/kernels/lucy.hpp"
#include "mote/operators/kernels/truncated_gauss.hpp"

namespace mote {

/// A list of kernels, each a template over the dimension.
template <template <int> class... K>
struct KernelList {};

/// Calls `visit.template operator()<K>()` for every kernel of the list, in order.
template <template <int> class... K, class Visit>
constexpr void for_each_kernel(KernelList<K...>, Visit&& visit) {
  (visit.template operator()<K>(), ...);
}

/// The smoothing kernels of mote. A new one is its own file and a word here.
using Kernels = KernelList<Gauss, TruncatedGauss, TruncatedGaussCosine, Lucy, CubicSpline>;

}  // namespace mote
