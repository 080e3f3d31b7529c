#include "mote/geometry/wall_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/particles/failure.hpp"

namespace mote {

WallPlace place_beyond_sides(const SpacePlan& plan, const Triple& place) {
  Triple inwards{};
  for (const SideWall& wall : plan.walls) {
    const auto [axis, upper] = wall.side;
    const double end = upper ? plan.upper[axis] : plan.lower[axis];
    const bool beyond = upper ? place[axis] > end : place[axis] < end;
    if (beyond) inwards[axis] = end - place[axis];
  }
  const double depth = std::hypot(inwards[0], inwards[1], inwards[2]);
  for (double& component : inwards) component /= depth;
  return {depth, inwards};
}

WallPlace place_in_wall(const SpacePlan& plan, const Region& region, const Triple& place) {
  const bool has_cavity = region.without != nullptr;
  const Shape& surface = has_cavity ? *region.without : *region.whole;
  const double distance = surface.distance(place);
  const double depth = std::max(0.0, has_cavity ? distance : -distance);
  Triple normal = outward_direction(surface, place, plan.dimension, 1e-4 * plan.spacing);
  const bool has_normal =
      std::ranges::any_of(normal, [](double component) { return component != 0; });
  if (!std::isfinite(depth) || !has_normal)
    throw InputError(
        region.key, fmt::format("the surface of the wall '{}' has no distance from {}: the formula "
                                "has no slope there",
                                region.body.name, place_in_words(place, plan.dimension)));
  if (has_cavity)
    for (double& component : normal) component = -component;
  return {depth, normal};
}

std::string place_in_words(const Triple& place, int dimension) {
  if (dimension == 2) return fmt::format("({:.6g}, {:.6g})", place[0], place[1]);
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", place[0], place[1], place[2]);
}

}  // namespace mote
