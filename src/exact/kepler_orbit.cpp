#include "mote/exact/kepler_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace mote {

namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

/// E - sin E for E from 0 on, without cancellation: the power series where E is small.
long double excess_over_sine(long double angle) {
  if (angle > 1) return angle - std::sin(angle);
  long double term = angle * angle * angle / 6, sum = term;
  for (int k = 4; std::abs(term) > std::numeric_limits<long double>::epsilon() * sum; k += 2) {
    term *= -angle * angle / (k * (k + 1));
    sum += term;
  }
  return sum;
}

/// 1 - cos E without cancellation.
long double versine(long double angle) {
  const long double half = std::sin(angle / 2);
  return 2 * half * half;
}

}  // namespace

/// Newton's iteration on f(E) = (1 - e) E + e (E - sin E) - M. On [0, pi] f rises and is convex, so
/// from beyond the root it comes down to it and stops there. The root is at most M + e, M/(1 - e)
/// (as E >= sin E), the cube root of 12 M/e (as E - sin E >= E^3/12), and pi.
long double eccentric_anomaly(long double mean_anomaly, long double eccentricity) {
  const long double e = eccentricity, m = std::abs(mean_anomaly);
  long double anomaly = std::min({m + e, m / (1 - e), std::cbrt(12 * m / e), pi});
  if (e == 0 || m == 0) return mean_anomaly;
  for (;;) {
    const long double value = (1 - e) * anomaly + e * excess_over_sine(anomaly) - m;
    const long double slope = (1 - e) + e * versine(anomaly);
    const long double next = anomaly - value / slope;
    if (!(next < anomaly)) return std::copysign(anomaly, mean_anomaly);
    anomaly = next;
  }
}

KeplerOrbit::KeplerOrbit(const KeplerElements& elements) : elements_(elements) {
  const auto& [mu, a, e, direction, time_of_pericentre] = elements_;
  if (!(mu > 0 && a > 0 && 0 <= e && e < 1 && std::isfinite(mu) && std::isfinite(a) &&
        std::isfinite(direction) && std::isfinite(time_of_pericentre)))
    throw std::domain_error(
        "an ellipse has a positive gravitational parameter and semi-major axis, and an "
        "eccentricity from 0 to below 1");
  const long double axis = a;
  mean_motion_ = std::sqrt(mu / (axis * axis * axis));
}

double KeplerOrbit::period() const { return static_cast<double>(2 * pi / mean_motion_); }

OrbitState KeplerOrbit::at(double time) const {
  const long double e = elements_.eccentricity, a = elements_.semi_major_axis;
  const long double since = static_cast<long double>(time) - elements_.time_of_pericentre;
  const long double anomaly = eccentric_anomaly(std::remainder(mean_motion_ * since, 2 * pi), e);
  const long double distance = (1 - e) + e * versine(anomaly);  // in semi-major axes
  const long double flattening = std::sqrt((1 - e) * (1 + e));
  const long double cosine = std::cos(static_cast<long double>(elements_.direction));
  const long double sine = std::sin(static_cast<long double>(elements_.direction));
  const auto turned = [&](long double scale, long double x, long double y) {
    return std::array<double, 2>{static_cast<double>(scale * (cosine * x - sine * y)),
                                 static_cast<double>(scale * (sine * x + cosine * y))};
  };
  const long double x = (1 - e) - versine(anomaly), y = flattening * std::sin(anomaly);
  const long double cubed = distance * distance * distance;
  return {.position = turned(a, x, y),
          .velocity = turned(a * mean_motion_ / distance, -std::sin(anomaly),
                             flattening * std::cos(anomaly)),
          .acceleration = turned(-a * mean_motion_ * mean_motion_ / cubed, x, y)};
}

}  // namespace mote
