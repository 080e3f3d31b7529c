#pragma once

#include <array>
#include <cstdint>

#include "mote/options/description.hpp"
#include "mote/particles/points.hpp"

namespace mote {

/// The layouts that exist in every dimension, by name.
inline const Choices& lattice_layouts() {
  static const Choices choices{{"lattice", "the midpoints of equal cells"},
                               {"jittered", "a lattice with every point moved at random"}};
  return choices;
}

/// What lies beyond a lattice: its own continuation, jitter included; a plain lattice; its mirror
/// image in the boundary; the points of the other end.
enum class LatticeExtension { formula, constant, mirror, periodic };

/// The cells of a box, `count[d]` along axis d, and the points in them: cell midpoints moved by up
/// to `jitter` cell sides in every direction, and as many layers of cells beyond every face.
template <int D>
struct LatticeShape {
  Vec<D> lower, upper;
  std::array<Index, D> count;
  double jitter = 0;
  std::uint64_t seed = 0;
  Index layers = 0;
  LatticeExtension extension = LatticeExtension::formula;

  /// Sides of a cell.
  Vec<D> cell() const;

  /// Volume of a cell.
  double volume() const { return cell().prod(); }
};

/// Positions and lengths of a lattice: first the cells of the box, x fastest, then the layers
/// around it in the same order. Component d of the move of point i is the draw i D + d of the seed,
/// jitter (2 u - 1) cell sides; the points of the layers take the next draws, so that they depend
/// on the number of layers, or move with the point that they are images of. The length of a cell is
/// the D-th root of its volume. Mass, density and the like are left to the caller.
template <int D>
Points<D> lattice_points(const LatticeShape<D>& shape);

extern template Points<1> lattice_points(const LatticeShape<1>&);
extern template Points<2> lattice_points(const LatticeShape<2>&);
extern template Points<3> lattice_points(const LatticeShape<3>&);

}  // namespace mote
