#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mote/geometry/box.hpp"
#include "mote/geometry/filling.hpp"
#include "mote/models/model.hpp"
#include "mote/operators/kernels/wendland_c2.hpp"
#include "mote/operators/terms/fluid_terms_on.hpp"

namespace mote::test {

using Place = Triple;

/// A fluid as a scenario would give it: a box, sides that are walls or periodic, and fields at the
/// start as functions of the place.
struct SpaceCase {
  SpacePlan plan;
  double smoothing_length = 1.5;  ///< in spacings; the kernel reaches twice as far
  std::function<double(const Place&)> pressure = [](const Place&) { return 0.0; };
  std::function<Triple(const Place&)> velocity = [](const Place&) { return Triple{}; };
  std::string search = "";
  std::optional<double> skin = std::nullopt;
};

/// Fluid from `lower` to `upper`, which is the domain as well.
template <class Case>
Case fluid_in_a_box(int dimension, double spacing, const Triple& upper,
                    const std::array<bool, 3>& periodic = {}) {
  Case flow;
  flow.plan.dimension = dimension;
  flow.plan.spacing = spacing;
  flow.plan.reach = 2 * flow.smoothing_length;
  flow.plan.upper = upper;
  flow.plan.periodic = periodic;
  Extent extent;
  std::copy_n(upper.begin(), dimension, extent.upper.begin());
  std::copy_n(flow.plan.lower.begin(), dimension, extent.lower.begin());
  flow.plan.regions.push_back(
      {.body = {.name = "fluid"}, .whole = std::make_shared<Box>(extent), .key = "domain"});
  return flow;
}

template <class Case>
Case& with_wall(Case& flow, int axis, bool upper, Body body = {}) {
  body.kind = BodyKind::wall;
  flow.plan.walls.push_back({body, {axis, upper}});
  return flow;
}

/// Walls on all sides that are not periodic.
template <class Case>
Case& with_walls(Case& flow, const Body& body = {}) {
  for (int axis = 0; axis < flow.plan.dimension; ++axis)
    for (const bool upper : {false, true})
      if (!flow.plan.periodic[static_cast<std::size_t>(axis)]) with_wall(flow, axis, upper, body);
  return flow;
}

/// Fluid particles up to `most` spacings away from their places on the lattice, along each axis.
template <class Case>
Case& in_disorder(Case& flow, double most = 0.2, std::uint64_t seed = 5) {
  flow.plan.jitter = most;
  flow.plan.seed = seed;
  return flow;
}

/// What a model is made from, but for the operator.
template <int D>
SpaceSetup setup_of(const SpaceCase& flow) {
  Filling filling = filled(flow.plan);
  SpaceSetup setup;
  setup.dimension = flow.plan.dimension;
  setup.lower = flow.plan.lower;
  setup.upper = flow.plan.upper;
  setup.periodic = flow.plan.periodic;
  setup.spacing = flow.plan.spacing;
  setup.bodies = std::move(filling.bodies);
  setup.position = std::move(filling.position);
  setup.body = std::move(filling.body);
  setup.wall_places = std::move(filling.wall_places);
  setup.initial = [flow](std::string_view field, const Triple& place) {
    if (field == "pressure") return flow.pressure(place);
    return flow.velocity(place)[static_cast<std::size_t>(field.back() - 'x')];
  };
  setup.terms = std::make_unique<FluidTermsOn<D, WendlandC2<D>>>();
  setup.smoothing_length = flow.smoothing_length;
  setup.search = flow.search;
  setup.skin = flow.skin;
  return setup;
}

template <template <int> class Flow, int D>
Vec<D> vector_of(const Flow<D>& flow, std::string_view field, Index i) {
  return Vec<D>::Map(flow.cloud().values(field).data() + std::ptrdiff_t{i} * D);
}

inline bool is_fluid(const Model& flow, Index i) {
  return flow.bodies()[static_cast<std::size_t>(flow.cloud().values("body")[i])].kind ==
         BodyKind::fluid;
}

/// The fluid's particles, by their numbers in the cloud.
inline std::vector<Index> fluid_of(const Model& flow) {
  std::vector<Index> fluid;
  for (Index i = 0; i < flow.cloud().count(); ++i)
    if (is_fluid(flow, i)) fluid.push_back(i);
  return fluid;
}

/// Largest of what `of(i)` gives for the fluid's particles.
template <class Of>
double most_in_fluid(const Model& flow, Of of) {
  double most = 0;
  for (const Index i : fluid_of(flow)) most = std::max(most, of(i));
  return most;
}

/// The highest speed in the fluid.
template <template <int> class Flow, int D>
double speed_of(const Flow<D>& flow) {
  return most_in_fluid(flow, [&](Index i) { return vector_of(flow, "velocity", i).norm(); });
}

/// A conserved quantity or a reading, by name.
inline double told(const Model& flow, const std::string& name) {
  for (const Conserved& quantity : flow.conserved())
    if (quantity.name == name) return quantity.value;
  for (const Reading& reading : flow.readings())
    if (reading.name == name) return reading.value;
  throw std::logic_error("no quantity " + name);
}

/// Largest drift of a component of the momentum between two states, relative to the sum of m |u| in
/// the first one.
inline double drift_between(const std::vector<Conserved>& start,
                            const std::vector<Conserved>& end) {
  double most = 0;
  for (std::size_t k = 0; k < start.size(); ++k)
    if (start[k].name.starts_with("momentum"))
      most = std::max(most, std::abs(end[k].value - start[k].value) / start[k].scale);
  return most;
}

/// All fields of the cloud, particle by particle in the order of ids.
inline std::vector<double> state_by_id(Model& flow) {
  flow.complete_snapshot();
  const auto id = flow.cloud().values("id");
  std::vector<std::size_t> order(id.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t k) { return id[k]; });
  std::vector<double> state;
  for (const std::size_t k : order)
    for (const Field& field : flow.cloud().fields())
      for (int d = 0; d < field.components; ++d)
        state.push_back(field.values[k * static_cast<std::size_t>(field.components) +
                                     static_cast<std::size_t>(d)]);
  return state;
}

}  // namespace mote::test
