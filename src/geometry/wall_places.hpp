#pragma once

#include <string>

#include "mote/geometry/space_plan.hpp"

namespace mote {

/// Where a place beyond sides that are walls is seen from the fluid: by the nearest point that is
/// not beyond any of them.
WallPlace place_beyond_sides(const SpacePlan& plan, const Triple& place);

/// Where a place in a wall is seen from the fluid: by the surface of what the wall leaves out if it
/// does, else by its own. Throws InputError where that surface has no distance.
WallPlace place_in_wall(const SpacePlan& plan, const Region& region, const Triple& place);

/// `(1, 2)`, or `(1, 2, 3)`.
std::string place_in_words(const Triple& place, int dimension);

}  // namespace mote
