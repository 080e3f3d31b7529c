#pragma once

#include <span>

#include "mote/particles/points.hpp"

namespace mote {

/// The particles of a line, in order, as seen by the extension.
struct LineOfParticles {
  std::span<const double> position, mass, density, length;
};

/// What lies beyond the ends of a line (Isshiki 2014).
enum class LineEnds {
  zero_gradient,  ///< cells like the end cell, (76), (84), (87)
  held,           ///< the same, and the end particles keep what they start with, (89)
  wall            ///< the line in a mirror: nothing passes
};

/// How a field looks in the mirror of a wall: a density is even, a velocity odd.
enum class Parity { even, odd };

/// Extension of a line beyond its ends (Isshiki 2014, section 5.1.1, N_end_cor): `cells` more
/// cells at each end. At free ends they are as long as the end cell and have its values: the zero
/// gradient of (76) without spending any of the particles on it. At walls they are mirror images.
class LineExtension {
 public:
  explicit LineExtension(Index cells) : cells_(cells) {}
  /// The walls, if these are the ends, stand at `lower` and `upper`.
  LineExtension(Index cells, LineEnds ends, double lower, double upper)
      : cells_(cells), ends_(ends), lower_(lower), upper_(upper) {}

  Index cells() const { return cells_; }
  LineEnds ends() const { return ends_; }

  /// Writes the particles and, behind them, the cells beyond the lower and the upper end, from the
  /// end outwards. At walls there must be as many particles as cells beyond an end.
  void extend(const LineOfParticles& line, Points<1>& points) const;

  /// Continues `values` of the particles beyond the ends.
  void fill(std::span<const double> values, std::span<double> extended,
            Parity parity = Parity::even) const;

  /// The particle, of `count`, whose value the k-th cell beyond the lower end has, or beyond the
  /// upper end from k = cells() on.
  Index owner(Index k, Index count) const;
  /// The sign with which the cell has that value.
  double sign(Parity parity) const {
    return ends_ == LineEnds::wall && parity == Parity::odd ? -1 : 1;
  }

 private:
  Index cells_;
  LineEnds ends_ = LineEnds::zero_gradient;
  double lower_ = 0, upper_ = 0;
};

}  // namespace mote
