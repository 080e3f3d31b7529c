#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// What the particles of a body are.
enum class BodyKind { fluid, wall };

/// Particles that belong together: a region of fluid, or a wall.
struct Body {
  std::string name;
  BodyKind kind = BodyKind::fluid;
  bool slips = false;                      ///< a wall along which the fluid slips freely
  std::function<Triple(double)> velocity;  ///< of a wall, by time; empty: it stands still
  bool travels = true;  ///< whether the wall's particles go along with its velocity, or only drag
  /// Corners of a wall in the plane, in order either way round, for models that need no particles
  /// in it; empty where the wall is no box, ball or polygon.
  std::vector<Triple> outline{};
};

/// Where a wall particle is seen from the fluid.
struct WallPlace {
  double depth = 0;  ///< distance from the wall's surface, positive inside the wall
  Triple normal{};   ///< unit vector from the surface into the fluid
};

}  // namespace mote
