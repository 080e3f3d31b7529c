#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "mote/operators/differential/all.hpp"
#include "mote/operators/kernels/all.hpp"

namespace mote::test {

/// An operator of mote on a line, by name.
struct NamedOperator {
  std::string name;
  std::function<std::unique_ptr<DifferentialOperator<1>>()> make;

  friend void PrintTo(const NamedOperator& op, std::ostream* out) { *out << op.name; }
};

/// Every operator that mote has: each family on each kernel, and the families without one.
inline std::vector<NamedOperator> operators_on_a_line() {
  std::vector<NamedOperator> operators;
  for_each_kernel_family(KernelFamilies{}, [&]<template <int, class> class Family>() {
    for_each_kernel(Kernels{}, [&]<template <int> class Kernel>() {
      using Operator = Family<1, Kernel<1>>;
      operators.push_back({std::string(Operator::family) + "_" + std::string(Kernel<1>::name),
                           [] { return std::make_unique<Operator>(); }});
    });
  });
  for_each_family(PlainFamilies{}, [&]<template <int> class Family>() {
    std::string name(Family<1>::family);
    if constexpr (requires { Family<1>::degree; }) name += "_" + std::to_string(Family<1>::degree);
    operators.push_back({name, [] { return std::make_unique<Family<1>>(); }});
  });
  return operators;
}

}  // namespace mote::test
