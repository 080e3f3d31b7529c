#pragma once

#include <string>

#include "mote/models/vortex_particles.hpp"

namespace mote {

/// How finely rings are made of particles.
struct RingResolution {
  double spacing = 1;    ///< of particles along the circle and across the core
  double blob_size = 0;  ///< of gauss cores, whose variance is a part of the ring's; else 0
  double threshold = 0;  ///< of vorticity over its highest, at which the core ends
};

/// A vortex ring as particles: one on the circle, and about it circular layers of 8, 16, 24, ... of
/// the same area, spacing^2, as Knio & Ghoniem (1990) place them; all that again in equal sectors
/// along the circle. Circulation is that of the ring, and so is the second moment of the core.
/// Throws InputError, in the name of `key`, for a ring that cannot be.
VortexList<3> ring_particles(const VortexRing& ring, const RingResolution& resolution,
                             const std::string& key);

}  // namespace mote
