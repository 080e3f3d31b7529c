#include "mote/quantum/wave_pieces.hpp"

#include <cmath>

namespace mote {
namespace {

Jet sum(double a, const Jet& f, double b, const Jet& g) {
  return {a * f.value + b * g.value, a * f.slope + b * g.slope, a * f.bend + b * g.bend};
}

/// c0 + c1 t + c2 t^2 + c3 t^3 of t = (x - lower)/h.
Jet cubic(const std::array<double, 4>& c, double t, double h) {
  return {c[0] + t * (c[1] + t * (c[2] + t * c[3])), (c[1] + t * (2 * c[2] + t * 3 * c[3])) / h,
          (2 * c[2] + 6 * t * c[3]) / (h * h)};
}

/// The cubics of Hermite for value and slope at the lower end and at the upper one.
std::array<Jet, 4> hermite(double t, double h) {
  return {cubic({1, 0, -3, 2}, t, h), cubic({0, h, -2 * h, h}, t, h), cubic({0, 0, 3, -2}, t, h),
          cubic({0, 0, -h, h}, t, h)};
}

/// The same for quadratics, which have no slope to choose at the lower end.
std::array<Jet, 4> quadratics(double t, double h) {
  return {cubic({1, -2, 1, 0}, t, h), Jet{}, cubic({0, 2, -1, 0}, t, h),
          cubic({0, -h, h, 0}, t, h)};
}

/// r u.
Jet times_place(double r, const Jet& u) {
  return {r * u.value, u.value + r * u.slope, 2 * u.slope + r * u.bend};
}

}  // namespace

/// For psi = r u: u = psi/r and u' = psi'/r - psi/r^2 at the ends.
std::array<Jet, 4> WaveInterval::functions(double x) const {
  const double h = upper - lower, t = (x - lower) / h;
  if (form == WaveForm::plain) return hermite(t, h);
  const std::array<Jet, 4> u = lower == 0 ? quadratics(t, h) : hermite(t, h);
  const auto of_value = [&](double r, const Jet& value, const Jet& slope) {
    return times_place(x, sum(1 / r, value, -1 / (r * r), slope));
  };
  const auto of_slope = [&](double r, const Jet& slope) {
    return times_place(x, sum(1 / r, slope, 0, slope));
  };
  const Jet upper_value = of_value(upper, u[2], u[3]), upper_slope = of_slope(upper, u[3]);
  if (lower == 0) return {Jet{}, times_place(x, u[0]), upper_value, upper_slope};
  return {of_value(lower, u[0], u[1]), of_slope(lower, u[1]), upper_value, upper_slope};
}

Jet WaveTail::factor(double distance) const {
  const double k = direction * decay;
  if (form == WaveForm::plain) return {1, -k, k * k};
  const double place = 1 + direction * distance / end;
  return {place, 1 / end - k * place, -2 * k / end + k * k * place};
}

Jet WaveTail::function(double distance) const {
  return sum(std::exp(-decay * distance), factor(distance), 0, {});
}

}  // namespace mote
