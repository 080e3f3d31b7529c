#include "mote/catalogue/flow_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mote/particles/failure.hpp"

namespace mote {

FlowStart::FlowStart(const FlowSetup& setup, std::string solution)
    : setup_(setup), solution_(std::move(solution)) {
  const SpaceStart& start = setup.start;
  const auto dimension = static_cast<std::size_t>(start.dimension);
  for (std::size_t i = 0; i < start.body.size(); ++i) {
    if (start.bodies[static_cast<std::size_t>(start.body[i])].kind != BodyKind::fluid) continue;
    Triple& place = fluid_.emplace_back();
    std::copy_n(start.position.begin() + static_cast<std::ptrdiff_t>(i * dimension), dimension,
                place.begin());
  }
  if (fluid_.empty()) refuse("needs a fluid");
  // Models that have these have the initial fields of a flow too.
  for (const char* name : {"density", "viscosity"}) parameter(name);
}

void FlowStart::refuse(const std::string& problem) const {
  throw InputError("check.against", solution_ + " " + problem);
}

double FlowStart::parameter(const std::string& name) const {
  const auto found = setup_.parameters.find(name);
  if (found == setup_.parameters.end())
    refuse(fmt::format("needs a model with a {}, which this one has not", name));
  return found->second;
}

Triple FlowStart::gravity() const {
  Triple gravity{};
  for (std::size_t d = 0; d < static_cast<std::size_t>(space().dimension); ++d)
    gravity[d] = parameter(std::string("gravity_") + axis_names[d]);
  return gravity;
}

double FlowStart::initial(std::string_view field, const Triple& place) const {
  return space().initial(field, place);
}

Triple FlowStart::velocity(const Triple& place) const {
  Triple velocity{};
  for (std::size_t d = 0; d < static_cast<std::size_t>(space().dimension); ++d)
    velocity[d] = initial(std::string("velocity_") + axis_names[d], place);
  return velocity;
}

double FlowStart::lowest(std::size_t axis) const {
  double lowest = fluid_.front()[axis];
  for (const Triple& place : fluid_) lowest = std::min(lowest, place[axis]);
  return lowest - 0.5 * space().spacing;
}

double FlowStart::highest(std::size_t axis) const {
  double highest = fluid_.front()[axis];
  for (const Triple& place : fluid_) highest = std::max(highest, place[axis]);
  return highest + 0.5 * space().spacing;
}

double FlowStart::velocity_difference(const FlowSolution& solution,
                                      const std::vector<Triple>& places) const {
  const auto dimension = static_cast<std::size_t>(space().dimension);
  double wrong = 0, size = 0;
  for (const Triple& place : places) {
    const Table expected = solution.at_places({place.data(), dimension}, space().dimension, 0);
    const Triple there = velocity(place);
    for (std::size_t d = 0; d < dimension; ++d) {
      wrong = std::max(wrong, std::abs(there[d] - expected[d].values[0]));
      size = std::max(size, std::abs(there[d]));
    }
  }
  return size > 0 ? wrong / size : wrong;
}

void FlowStart::need_dimension(int dimension) const {
  if (space().dimension != dimension)
    refuse(
        fmt::format("is a flow in {} dimensions, this one is in {}", dimension, space().dimension));
}

void FlowStart::need_rest() const {
  for (const Triple& place : fluid_)
    if (velocity(place) != Triple{})
      refuse(fmt::format("starts from rest, and this fluid moves at ({:.6g}, {:.6g}, {:.6g})",
                         place[0], place[1], place[2]));
}

void FlowStart::need_no_gravity() const {
  if (gravity() != Triple{}) refuse("has no gravity, this flow has");
}

void FlowStart::need_velocities_of(const FlowSolution& solution, const std::vector<Triple>& places,
                                   std::string_view refusal) const {
  const double difference = velocity_difference(solution, places);
  if (difference > same_start) refuse(fmt::format(fmt::runtime(refusal), difference));
}

}  // namespace mote
