#include "mote/exact/poiseuille_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace mote {
namespace {

using std::numbers::pi;

/// Both forms reach rounding with this many terms on their side of this time.
constexpr double early = 0.05;
constexpr int terms = 12;

/// Four times the second repeated integral of erfc.
double repeated(double z) {
  return (1 + 2 * z * z) * std::erfc(z) - 2 * z * std::exp(-z * z) / std::sqrt(pi);
}

double early_speed(double y, double time) {
  const double scale = 2 * std::sqrt(time);
  double sum = 1;
  for (int m = 0; m < terms; ++m) {
    const double images = repeated((m + y) / scale) + repeated((m + 1 - y) / scale);
    sum -= m % 2 == 0 ? images : -images;
  }
  return time * sum;
}

double late_speed(double y, double time) {
  double speed = 0.5 * y * (1 - y);
  for (int n = 1; n < 2 * terms; n += 2) {
    const double wave = n * pi;
    speed -= 4 / (wave * wave * wave) * std::sin(wave * y) * std::exp(-wave * wave * time);
  }
  return speed;
}

}  // namespace

double poiseuille_start(double y, double time, double width, double viscosity) {
  if (time <= 0) return 0;
  const double scale = width * width / viscosity;
  const double t = time / scale;
  return scale * (t < early ? early_speed(y / width, t) : late_speed(y / width, t));
}

std::string PoiseuilleStart::statement() const {
  return fmt::format(
      "poiseuille_start is exact for a channel of width {:.6g} without ends and the viscosity "
      "{:.6g}",
      channel_.width(), viscosity_);
}

Table PoiseuilleStart::at_places(std::span<const double> position, int dimension,
                                 double time) const {
  return flow_table(position, dimension, WithPressure::no, [&](const auto& place) {
    const double unit =
        poiseuille_start(channel_.above_lower(place), time, channel_.width(), viscosity_);
    return FlowState{{unit * force_[0], unit * force_[1], unit * force_[2]}};
  });
}

}  // namespace mote
