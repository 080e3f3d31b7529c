#pragma once

#include <functional>
#include <span>

#include "mote/models/vortex_particles.hpp"
#include "mote/particles/vector.hpp"

namespace mote {

/// Sums over vortices in space.
struct SpaceVortexMoments {
  Vec<3> circulation = Vec<3>::Zero();      ///< sum of alpha
  double magnitude = 0;                     ///< of |alpha|
  Vec<3> impulse = Vec<3>::Zero();          ///< of x cross alpha/2
  double impulse_scale = 0;                 ///< of |x| |alpha|/2
  Vec<3> angular_impulse = Vec<3>::Zero();  ///< of x cross (x cross alpha)/3
  double angular_scale = 0;                 ///< of |x|^2 |alpha|/3
  Vec<3> first = Vec<3>::Zero();            ///< of |alpha| x

  Vec<3> centre() const { return first / magnitude; }
  /// Of a ring: the mean distance from its axis, from |alpha| to |alpha|, 2 |impulse|/magnitude
  /// with the impulse about the centre.
  double radius() const;
};

/// Of the vortices i with `counts(i)`; all of them, if it is empty.
SpaceVortexMoments space_vortex_moments(const VortexParticles<3>& vortices,
                                        const std::function<bool(Index)>& counts = {});

}  // namespace mote
