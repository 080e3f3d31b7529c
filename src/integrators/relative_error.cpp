#include "mote/integrators/relative_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote {

double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

double relative_error(const KeptValues& start, std::span<const Evolving> rates, double step) {
  double worst = 0;
  for (std::size_t part = 0; part < rates.size(); ++part) {
    const double error = step * largest_magnitude(rates[part].rate);
    const double scale =
        std::max(largest_magnitude(start.values(part)), largest_magnitude(rates[part].value));
    if (std::isinf(scale)) return scale;
    if (error > 0) worst = std::max(worst, error / scale);
  }
  return worst;
}

double relative_error(Stages& stages, std::span<const double> weights, double step) {
  return std::max(
      relative_error(stages.drifted.values_at_start(), stages.drifted.combined(weights), step),
      relative_error(stages.kicked.values_at_start(), stages.kicked.combined(weights), step));
}

}  // namespace mote
