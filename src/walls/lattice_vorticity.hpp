#pragma once

#include <vector>

#include "mote/walls/cut_lattice.hpp"

namespace mote {

/// Circulations of particles that stand on the nodes of a lattice.
struct LatticeVorticity {
  NodeBox box;
  std::vector<double> circulation;
};

/// Linear impulse, over the density, of a vortex: circulation times (y, -x).
inline Complex impulse_of(double circulation, Complex place) {
  return circulation * Complex(place.imag(), -place.real());
}

/// What particles that are left out take with them.
struct LostVorticity {
  double circulation = 0;
  Complex impulse{};
};

}  // namespace mote
