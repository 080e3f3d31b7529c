#pragma once

#include <cstdint>
#include <vector>

#include "mote/geometry/space_plan.hpp"

namespace mote {

/// The particles that fill a plan.
struct Filling {
  std::vector<Body> bodies;        ///< the fluids, the walls on sides, the other walls
  std::vector<double> position;    ///< `dimension` numbers a particle: all fluids, then all walls
  std::vector<std::int32_t> body;  ///< of every particle: its number among `bodies`
  std::vector<WallPlace> wall_places;  ///< of every wall particle, in order
};

/// Particles in the middle of every cell of a lattice that is in a region or, beyond a side that is
/// a wall, as deep as the operator reaches. A corner belongs to the wall that is first in the list,
/// and to a region rather than to the wall on a side. Body by body, x fastest.
///
/// Throws InputError, with the key of the region, for fluid beyond the domain, regions on top of
/// each other, regions without a particle, and walls that the operator sees through.
Filling filled(const SpacePlan& plan);

/// A number that the particles of a plan cannot exceed. Throws InputError as SpaceLattice does.
double most_particles(const SpacePlan& plan);

}  // namespace mote
