#pragma once

#include <span>

#include "mote/walls/lattice_vorticity.hpp"
#include "mote/walls/panel_bodies.hpp"

namespace mote {

/// Circulations of particles on the nodes of a cut lattice that may carry one. Away from walls by
/// the M4' kernel (Monaghan 1985), which conserves circulation and the first and second moments;
/// where one of its 16 nodes is in a wall, by least squares among the nodes outside that conserves
/// the same moments, or only the first where they would be taken from too far.
LatticeVorticity remeshed(const Vortices& particles, const CutLattice& lattice);

/// The particles of a lattice whose circulation is above `least` in size; what the others have is
/// added to `lost`.
struct RemeshedParticles {
  std::vector<Complex> place;
  std::vector<double> circulation;
};
RemeshedParticles particles_of(const LatticeVorticity& vorticity, const CutLattice& lattice,
                               double least, LostVorticity& lost);

}  // namespace mote
