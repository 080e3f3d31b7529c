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
  double pressure;
};

/// The fluid that a wall particle has seen, carried on to it: the pressure with the weight of the
/// fluid between under the acceleration `pull` relative to the wall (Adami, Hu & Adams 2012, (27)),
/// the velocity linearly through the wall's own, and where the wall slips only its normal part so.
/// `otherwise` is the pressure where no fluid is near.
template <int D>
ContinuedFluid<D> continue_into_wall(const FluidSeen<D>& seen, const Surface<D>& surface,
                                     bool slips, const Vec<D>& pull, double otherwise) {
  ContinuedFluid<D> ghost{surface.velocity - surface.depth * seen.shear, otherwise};
  if (!(seen.weight > 0)) return ghost;
  ghost.pressure = seen.pressure + pull.dot(seen.offset);
  if (!slips) return ghost;
  const Vec<D>& n = surface.normal;
  ghost.velocity = seen.velocity + (ghost.velocity - seen.velocity).dot(n) * n;
  return ghost;
}

}  // namespace mote
