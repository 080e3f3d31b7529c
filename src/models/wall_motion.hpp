#pragma once

#include <vector>

#include "mote/models/space.hpp"
#include "mote/operators/terms/fluid_terms.hpp"

namespace mote {

/// How a body moves at a time.
struct WallMotion {
  Triple velocity{}, acceleration{};
};

/// Notes how all of them move now; accelerations are differences over twice `half` of time.
void observe(const std::vector<Body>& bodies, double time, double half,
             std::vector<WallMotion>& motions);

/// The fluid as it goes on into a wall.
template <int D>
struct ContinuedFluid {
  Vec<D> velocity;
  Vec<D> carrying;  ///< the velocity that carries mass
  double pressure;
};

/// The fluid that a wall particle has seen, carried on to it: the pressure with the weight of the
/// fluid between under the acceleration `pull` relative to the wall (Adami, Hu & Adams 2012, (27)),
/// the velocity linearly through the wall's own. Only the normal part of it carries mass, and along
/// the wall the fluid goes on as it is (De Leffe, Le Touze & Alessandrini 2011): where a wall that
/// drags meets one that does not, mass would flow through their corner otherwise. Where the wall
/// slips, that is all of its velocity. `otherwise` is the pressure where no fluid is near.
template <int D>
ContinuedFluid<D> continue_into_wall(const FluidSeen<D>& seen, const Surface<D>& surface,
                                     bool slips, const Vec<D>& pull, double otherwise) {
  const Vec<D> velocity = surface.velocity - surface.depth * seen.shear;
  if (!(seen.weight > 0)) return {velocity, velocity, otherwise};
  const Vec<D>& n = surface.normal;
  const Vec<D> carrying = seen.velocity + (velocity - seen.velocity).dot(n) * n;
  return {slips ? carrying : velocity, carrying, seen.pressure + pull.dot(seen.offset)};
}

}  // namespace mote
