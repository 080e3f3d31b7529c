#pragma once

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// Translations of expansions of a degree along z, where each order is a matrix of its own. Powers
/// of the radii are put on outside.

/// Multipole to local where the target is along +z, without powers of the distance either.
void turn_inward(int degree, const Lanes* multipole, Lanes* local);

/// To a multipole whose centre is below that of `multipole`; `powers` are of the length between
/// them over the new radius.
void move_multipole(int degree, const Lanes* powers, const Lanes* multipole, Lanes* moved);

/// To a local expansion whose centre is above that of `local`; `powers` are of the length between
/// them over the old radius.
void move_local(int degree, const Lanes* powers, const Lanes* local, Lanes* moved);

}  // namespace mote
