#include "mote/catalogue/catalogue.hpp"

#include "mote/catalogue/exact.hpp"
#include "mote/integrators/all.hpp"
#include "mote/integrators/paths.hpp"
#include "mote/models/all.hpp"

namespace mote {

std::unique_ptr<AnyOperator> Catalogue::make_operator(const std::string& family,
                                                      const std::string& member,
                                                      std::int64_t dimension) const {
  for (const OperatorEntry& entry : operators)
    if (entry.family == family && entry.member == member) return entry.make(dimension);
  return nullptr;
}

Catalogue standard_catalogue() {
  Catalogue catalogue;
  for_each_kernel(Kernels{},
                  [&]<template <int> class Kernel>() { catalogue.add_kernel<Kernel>(); });
  for_each_family(PlainFamilies{},
                  [&]<template <int> class Family>() { catalogue.add_family<Family>(); });
  for_each_type(Integrators{}, [&]<class Method>() { catalogue.add_integrator<Method>(); });
  for_each_type(Paths{}, [&]<class Way>() { catalogue.add_path<Way>(); });
  for_each_type(Models{}, [&]<class Recipe>() { catalogue.add_model<Recipe>(); });
  for_each_type(Layouts{}, [&]<class Layout>() { catalogue.add_layout<Layout>(); });
  catalogue.exact_solutions = exact_entries();
  return catalogue;
}

}  // namespace mote
