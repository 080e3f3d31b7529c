#pragma once

#include <span>
#include <vector>

#include "mote/xivas/simplex_mesh.hpp"

namespace mote {

/// How the value at a point of the mesh follows from the particles in the cells around it, each
/// weighted by the point's linear shape function: Nadukandi 2014, (6).
enum class ProjectionKind {
  mean,           ///< their weighted mean: exact for constants, order 1, and 2 where they balance
  least_squares,  ///< the linear function that fits them best: exact for linear fields, order 2
};

/// Carries vectors over from particles to the points of a mesh.
///
/// A point whose particles fix no linear function well (too few, or nearly in one plane) takes
/// their mean, and one without particles the mean of the points that share a cell with it and have
/// a value: `without_fit` and `without_particles` count them.
template <int D>
class Projection {
 public:
  /// Of particles in these cells of the mesh, D numbers each. Throws InputError if there are none.
  Projection(const SimplexMesh<D>& mesh, std::span<const double> positions,
             std::span<const Index> cells, ProjectionKind kind);

  /// The values at the points, from those of the particles; D numbers each.
  std::vector<double> project(std::span<const double> values) const;

  Index without_fit() const { return without_fit_; }
  Index without_particles() const { return static_cast<Index>(empty_.size()); }

 private:
  /// A particle's share in the value at a point.
  struct Share {
    Index particle;
    double weight;
  };
  /// A point without particles, and the points whose mean it takes, which come before it.
  struct Empty {
    Index point;
    std::vector<Index> from;
  };

  void weigh_for_means();
  void weigh_for_fits(std::span<const double> positions);
  void find_empty();

  const SimplexMesh<D>& mesh_;
  std::vector<std::vector<Share>> shares_;  ///< of every point
  std::vector<Empty> empty_;
  Index without_fit_ = 0;
};

extern template class Projection<2>;
extern template class Projection<3>;

}  // namespace mote
