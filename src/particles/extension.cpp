#include "mote/particles/extension.hpp"

#include <algorithm>

namespace mote {

void LineExtension::extend(const LineOfParticles& line, Points<1>& points) const {
  const auto count = static_cast<Index>(line.position.size());
  points.resize(count + 2 * cells_, count);
  fill(line.mass, points.mass);
  fill(line.density, points.density);
  fill(line.length, points.length);
  fill(line.position, points.position);
  double* const below = points.position.data() + count;
  double* const above = below + cells_;
  for (Index k = 0; k < cells_; ++k) {
    if (ends_ == LineEnds::wall) {
      below[k] = 2 * lower_ - below[k];
      above[k] = 2 * upper_ - above[k];
    } else {
      below[k] -= (k + 1) * line.length.front();
      above[k] += (k + 1) * line.length.back();
    }
  }
}

void LineExtension::fill(std::span<const double> values, std::span<double> extended,
                         Parity parity) const {
  const auto count = static_cast<Index>(values.size());
  std::ranges::copy(values, extended.begin());
  for (Index k = 0; k < 2 * cells_; ++k)
    extended[count + k] = sign(parity) * values[owner(k, count)];
}

Index LineExtension::owner(Index k, Index count) const {
  const Index from_end = ends_ == LineEnds::wall ? k % cells_ : 0;
  return k < cells_ ? from_end : count - 1 - from_end;
}

}  // namespace mote
