#pragma once

#include <span>

#include "mote/walls/lattice_vorticity.hpp"
#include "mote/walls/panel_bodies.hpp"

namespace mote {

/// Circulations of particles on the nodes of a cut lattice that may carry one. Away from walls by
/// the M4' kernel (Monaghan 1985), which conserves circulation and the first and second moments;
/// where one of its 16 nodes is in a wall, by least squares among the nodes outside that conserves
/// the same moments, or only the first where they would be taken from too far. Throws
/// NumericalFailure for a particle that has got deep into a body.
LatticeVorticity remeshed(const Vortices& particles, const CutLattice& lattice);

/// Empties the nodes whose circulation is no larger than `least` in size, and says what they had.
LostVorticity drop_weak(const CutLattice& lattice, double least, LatticeVorticity& vorticity);

/// The particles of a lattice, in the order of its nodes; empty nodes have none.
struct LatticeParticles {
  std::vector<Complex> place;
  std::vector<double> circulation, area;

  Vortices vortices() const { return {place, circulation}; }
};
LatticeParticles particles_of(const LatticeVorticity& vorticity, const CutLattice& lattice);

}  // namespace mote
