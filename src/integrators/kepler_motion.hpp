#pragma once

#include <array>

#include "mote/integrators/packs.hpp"

namespace mote {

/// Vectors in space, eight side by side.
using PackVector = std::array<Pack, 3>;

/// Moves eight bodies on along their Kepler orbits x'' = -pull x/|x|^3, of any eccentricity, for a
/// time of any length and sign: by universal variables and the f and g functions of Gauss (Danby
/// 1988, Fundamentals of Celestial Mechanics, ch. 6.9; Rein & Tamayo 2015, MNRAS 452, 376). Where
/// nothing pulls, motion is straight.
void move_on_orbits(const Pack& pull, double time, PackVector& place, PackVector& velocity);

}  // namespace mote
