#include "mote/exact/couette_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace mote {
namespace {

/// Both forms reach rounding with this many terms on their side of this time.
constexpr double early = 0.05;
constexpr int terms = 24;

double early_speed(double y, double time) {
  const double scale = 2 * std::sqrt(time);
  double speed = 0;
  for (int image = 1; image < terms; image += 2)
    speed += std::erfc((image - y) / scale) - std::erfc((image + y) / scale);
  return speed;
}

double late_speed(double y, double time) {
  double speed = y;
  for (int n = 1; n < terms; ++n) {
    const double wave = n * std::numbers::pi;
    const double term = 2 / wave * std::sin(wave * y) * std::exp(-wave * wave * time);
    speed += n % 2 == 0 ? term : -term;
  }
  return speed;
}

}  // namespace

double couette_start(double y, double time, double width, double viscosity) {
  if (time <= 0) return 0;
  const double t = time * viscosity / (width * width);
  return t < early ? early_speed(y / width, t) : late_speed(y / width, t);
}

std::string CouetteStart::statement() const {
  return fmt::format(
      "couette_start is exact for a channel of width {:.6g} without ends and the viscosity {:.6g}",
      channel_.width(), viscosity_);
}

Table CouetteStart::at_places(std::span<const double> position, int dimension, double time) const {
  return flow_table(position, dimension, WithPressure::no, [&](const auto& place) {
    const double width = channel_.width(), y = channel_.above_lower(place);
    const double by_upper = couette_start(y, time, width, viscosity_);
    const double by_lower = couette_start(width - y, time, width, viscosity_);
    FlowState state;
    for (std::size_t d = 0; d < 3; ++d)
      state.velocity[d] = by_upper * walls_.upper[d] + by_lower * walls_.lower[d];
    return state;
  });
}

}  // namespace mote
