#pragma once

#include <vector>

#include "mote/walls/cut_lattice.hpp"

namespace mote {

/// Circulations of particles that stand on the nodes of a lattice.
struct LatticeVorticity {
  NodeBox box;
  std::vector<double> circulation;
};

/// What particles that are left out take with them.
struct LostVorticity {
  double circulation = 0;
  Complex impulse{};  ///< sum of circulation times (y, -x)
};

}  // namespace mote
