#pragma once

#include "mote/models/vortex_particles.hpp"

namespace mote {

/// The lattice that vortices are put on: nodes in the middles of cells from `lower` on, in all of
/// space or, in a periodic box, as many as it has.
struct VortexLatticeOptions {
  double spacing = 1;
  Triple lower{};
  std::array<Index, 3> cells{};  ///< along each axis of a periodic box; 0: no end
  double threshold = 0;          ///< of circulation over its highest, below which nodes stay empty
};

/// What remeshing did: the sum of the magnitudes that empty nodes would have had, over that of all.
struct RemeshingLoss {
  double dropped = 0;
};

/// Puts vortices on a lattice by products of M4', Monaghan's (1985) kernel of four nodes an axis,
///   1 - 5/2 s^2 + 3/2 s^3 for s < 1,   (2 - s)^2 (1 - s)/2 for s < 2,
/// whose sums with 1, x and x^2 are exact: circulation, linear and angular impulse stay, in space
/// of each component. Nodes below the threshold stay empty; what they would have had is given back
/// to the others by
///   |Gamma_i| (a + b . x_i + c x_i^2),
/// with a, b and c such that all three stay (in a box a alone). Returns the vortices in the order
/// of nodes, x fastest.
template <int D>
VortexList<D> remeshed(const VortexList<D>& vortices, const VortexLatticeOptions& lattice,
                       RemeshingLoss* loss = nullptr);

/// The same with a Gauss function of this standard deviation in place of M4': vorticity diffuses,
/// and the second moments grow by as much as that says. Accurate from 1.3 spacings on.
template <int D>
VortexList<D> spread_on_lattice(const VortexList<D>& vortices, const VortexLatticeOptions& lattice,
                                double deviation, RemeshingLoss* loss = nullptr);

extern template VortexList<2> remeshed(const VortexList<2>&, const VortexLatticeOptions&,
                                       RemeshingLoss*);
extern template VortexList<2> spread_on_lattice(const VortexList<2>&, const VortexLatticeOptions&,
                                                double, RemeshingLoss*);
extern template VortexList<3> remeshed(const VortexList<3>&, const VortexLatticeOptions&,
                                       RemeshingLoss*);
extern template VortexList<3> spread_on_lattice(const VortexList<3>&, const VortexLatticeOptions&,
                                                double, RemeshingLoss*);

/// From so many spacings on sums of a Gauss function over a lattice are integrals: their error is
/// 2 exp(-2 pi^2 s^2).
inline constexpr double least_deviation = 1.3;

}  // namespace mote
