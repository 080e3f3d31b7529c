#pragma once

#include <span>

#include "mote/particles/points.hpp"

namespace mote {

/// The particles of a line, in order, as seen by the extension.
struct LineOfParticles {
  std::span<const double> position, mass, density, length;
};

/// Extension of a line beyond its ends (Isshiki 2014, section 5.1.1, N_end_cor): `cells` more
/// cells at each end, as long as the end cell and with its values. This is the zero gradient of
/// (76) without spending any of the particles on it.
class LineExtension {
 public:
  explicit LineExtension(Index cells) : cells_(cells) {}

  Index cells() const { return cells_; }

  /// Writes the particles and, behind them, the cells beyond the lower and the upper end.
  void extend(const LineOfParticles& line, Points<1>& points) const;

  /// Continues `values` of the particles with the values of the end cells.
  void fill(std::span<const double> values, std::span<double> extended) const;

 private:
  Index cells_;
};

}  // namespace mote
