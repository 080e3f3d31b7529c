#include "mote/exact/elliptical_drop.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace mote {

EllipticalDrop::Shape EllipticalDrop::shape(double time) const {
  const double mean = std::sqrt(start_.semi_axis_x * start_.semi_axis_y);
  const double start = std::log(start_.semi_axis_x / mean);
  const double energy = std::cosh(2 * start);
  const auto slope = [&](double s) { return start_.rate * std::sqrt(energy / std::cosh(2 * s)); };
  const auto steps = static_cast<std::int64_t>(std::ceil(2000 * std::abs(start_.rate) * time));
  const double h = steps > 0 ? time / static_cast<double>(steps) : 0;
  double s = start;
  for (std::int64_t n = 0; n < steps; ++n) {
    const double k1 = slope(s), k2 = slope(s + 0.5 * h * k1), k3 = slope(s + 0.5 * h * k2);
    s += h / 6 * (k1 + 2 * k2 + 2 * k3 + slope(s + h * k3));
  }
  return {mean * std::exp(s), mean * std::exp(-s), slope(s)};
}

std::string EllipticalDrop::statement() const {
  return fmt::format(
      "elliptical_drop is exact for an incompressible drop of semi-axes {:.6g} and {:.6g} at the "
      "start and the rate {:.6g}, without viscosity",
      start_.semi_axis_x, start_.semi_axis_y, start_.rate);
}

Table EllipticalDrop::at_places(std::span<const double> position, int dimension,
                                double time) const {
  const auto [a, b, rate] = shape(time);
  const double stiffness = 2 * rate * rate * a * a * b * b / (a * a + b * b);
  return flow_table(position, dimension, WithPressure::yes, [&](const auto& place) {
    const double x = place[0] - start_.centre[0], y = place[1] - start_.centre[1];
    const double inside = 1 - (x / a) * (x / a) - (y / b) * (y / b);
    return FlowState{{rate * x, -rate * y}, 0.5 * start_.density * stiffness * inside};
  });
}

}  // namespace mote
