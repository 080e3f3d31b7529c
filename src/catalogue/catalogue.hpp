#pragma once

#include <memory>
#include <string>
#include <utility>

#include "mote/catalogue/entries.hpp"
#include "mote/operators/differential/all.hpp"
#include "mote/operators/kernels/all.hpp"
#include "mote/operators/terms/fluid_terms_by_kernel.hpp"

namespace mote {

/// Makes Operator<dimension>, or nothing beyond its highest dimension.
template <template <int> class Operator>
std::unique_ptr<AnyOperator> new_operator(std::int64_t dimension) {
  constexpr int highest = Operator<1>::highest_dimension;
  if (dimension == 1) return std::make_unique<Operator<1>>();
  if constexpr (highest >= 2)
    if (dimension == 2) return std::make_unique<Operator<2>>();
  if constexpr (highest >= 3)
    if (dimension == 3) return std::make_unique<Operator<3>>();
  return nullptr;
}

/// Makes the pair terms of a fluid in two or three dimensions.
template <template <int> class Kernel>
std::unique_ptr<AnyFluidTerms> new_fluid_terms(std::int64_t dimension) {
  if (dimension == 2) return fluid_terms_by<2>(Kernel<2>());
  if (dimension == 3) return fluid_terms_by<3>(Kernel<3>());
  return nullptr;
}

/// A family on a kernel, as a template over the dimension.
template <template <int, class> class Family, template <int> class Kernel>
struct OnKernel {
  template <int D>
  using Operator = Family<D, Kernel<D>>;
};

template <template <int> class Kernel>
void Catalogue::add_kernel() {
  kernels.push_back({choice_of<Kernel<1>>(), new_fluid_terms<Kernel>});
  for_each_kernel_family(KernelFamilies{}, [&]<template <int, class> class Family>() {
    operators.push_back({std::string(Family<1, Kernel<1>>::family), "kernel",
                         std::string(Kernel<1>::name), std::string(Kernel<1>::summary),
                         new_operator<OnKernel<Family, Kernel>::template Operator>});
  });
}

template <template <int> class Family>
void Catalogue::add_family() {
  OperatorEntry entry{std::string(Family<1>::family), "", "", std::string(Family<1>::summary),
                      new_operator<Family>};
  if constexpr (requires { Family<1>::degree; }) {
    entry.distinction = "degree";
    entry.member = std::to_string(Family<1>::degree);
  }
  operators.push_back(std::move(entry));
}

template <class Method>
void Catalogue::add_integrator() {
  IntegratorEntry entry{choice_of<Method>(), [] { return std::make_unique<Method>(); }, {}};
  if constexpr (requires { Method::default_tolerance; })
    entry.default_tolerance = Method::default_tolerance;
  integrators.push_back(std::move(entry));
}

template <class Way>
void Catalogue::add_path() {
  paths.push_back({choice_of<Way>(), [] { return std::make_unique<Way>(); }});
}

template <class Recipe>
void Catalogue::add_model() {
  models.push_back({choice_of<Recipe>(), [] { return std::make_unique<Recipe>(); }});
}

template <class Layout>
void Catalogue::add_layout() {
  layouts.push_back({choice_of<Layout>(), cells_of_line<Layout>, Layout::relative_length});
}

}  // namespace mote
