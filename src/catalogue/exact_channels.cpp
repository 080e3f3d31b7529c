#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mote/catalogue/exact_flows.hpp"
#include "mote/catalogue/flow_start.hpp"
#include "mote/exact/couette_start.hpp"
#include "mote/exact/poiseuille_start.hpp"

namespace mote {
namespace {

/// One of the two walls of a channel.
struct Side {
  double surface;
  std::int32_t body;
};

struct Walls {
  Channel channel;
  std::int32_t lower = 0, upper = 0;  ///< numbers of the bodies
};

std::optional<std::size_t> axis_of(const Triple& normal) {
  for (std::size_t d = 0; d < 3; ++d)
    if (std::abs(std::abs(normal[d]) - 1) < same_start) return d;
  return std::nullopt;
}

/// The channel whose sides all wall particles are behind, lower ones below it, upper ones above.
Walls walls_of(const FlowStart& flow) {
  const SpaceStart& start = flow.space();
  const auto dimension = static_cast<std::size_t>(start.dimension);
  const std::size_t first = start.body.size() - start.wall_places.size();
  std::optional<std::size_t> axis;
  std::array<std::optional<Side>, 2> sides;
  for (std::size_t w = 0; w < start.wall_places.size(); ++w) {
    const auto& [depth, normal] = start.wall_places[w];
    const auto across = axis_of(normal);
    if (!axis) axis = across;
    if (!across || across != axis) flow.refuse("needs two plane walls that face each other");
    const double surface = start.position[(first + w) * dimension + *axis] + depth * normal[*axis];
    auto& side = sides[normal[*axis] > 0 ? 0 : 1];
    if (!side) side = Side{surface, start.body[first + w]};
    if (std::abs(side->surface - surface) > same_start * start.spacing)
      flow.refuse("needs walls that are plane");
  }
  if (!sides[0] || !sides[1]) flow.refuse("needs two plane walls that face each other");
  return {{static_cast<int>(*axis), sides[0]->surface, sides[1]->surface},
          sides[0]->body,
          sides[1]->body};
}

/// Velocity of a wall that holds the fluid and keeps its velocity, along itself.
Triple steady_velocity(const FlowStart& flow, std::int32_t number, int axis) {
  const Body& body = flow.space().bodies[static_cast<std::size_t>(number)];
  if (body.slips)
    flow.refuse(fmt::format("needs walls that hold the fluid, and '{}' does not", body.name));
  if (!body.velocity) return {};
  const Triple velocity = body.velocity(0);
  for (const double time : {1e-3, 1.0, 1e3})
    if (body.velocity(time) != velocity)
      flow.refuse(
          fmt::format("needs walls of constant velocity, and that of '{}' changes", body.name));
  if (velocity[static_cast<std::size_t>(axis)] != 0)
    flow.refuse(
        fmt::format("needs walls that move along themselves, and '{}' does not", body.name));
  return velocity;
}

/// A flow along the walls must not end.
void need_no_ends(const FlowStart& flow, const Triple& along) {
  for (std::size_t d = 0; d < 3; ++d)
    if (along[d] != 0 && !flow.space().periodic[d])
      flow.refuse(
          fmt::format("has no ends, so the domain must be periodic along {}", axis_names[d]));
}

double viscosity_of(const FlowStart& flow) {
  const double viscosity = flow.parameter("viscosity");
  if (viscosity <= 0) flow.refuse("needs a viscosity, this fluid has none");
  return viscosity;
}

}  // namespace

std::unique_ptr<FlowSolution> poiseuille_from(const FlowSetup& setup) {
  const FlowStart flow(setup, std::string(PoiseuilleStart::name));
  const auto [channel, lower, upper] = walls_of(flow);
  flow.need_rest();
  for (const std::int32_t wall : {lower, upper})
    if (steady_velocity(flow, wall, channel.axis) != Triple{}) flow.refuse("needs walls at rest");
  const Triple force = flow.gravity();
  if (force == Triple{} || force[static_cast<std::size_t>(channel.axis)] != 0)
    flow.refuse("needs a force, the gravity of the model, along the walls alone");
  need_no_ends(flow, force);
  return std::make_unique<PoiseuilleStart>(channel, force, viscosity_of(flow));
}

std::unique_ptr<FlowSolution> couette_from(const FlowSetup& setup) {
  const FlowStart flow(setup, std::string(CouetteStart::name));
  const auto [channel, lower, upper] = walls_of(flow);
  flow.need_rest();
  flow.need_no_gravity();
  const CouetteStart::Walls walls{steady_velocity(flow, lower, channel.axis),
                                  steady_velocity(flow, upper, channel.axis)};
  if (walls.lower == walls.upper) flow.refuse("needs a wall that moves");
  need_no_ends(flow, walls.lower);
  need_no_ends(flow, walls.upper);
  return std::make_unique<CouetteStart>(channel, walls, viscosity_of(flow));
}

}  // namespace mote
