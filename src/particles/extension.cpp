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
  for (Index k = 0; k < cells_; ++k) {
    points.position[count + k] -= (k + 1) * line.length.front();
    points.position[count + cells_ + k] += (k + 1) * line.length.back();
  }
}

void LineExtension::fill(std::span<const double> values, std::span<double> extended) const {
  const auto beyond = std::ranges::copy(values, extended.begin()).out;
  std::fill_n(std::fill_n(beyond, cells_, values.front()), cells_, values.back());
}

}  // namespace mote
