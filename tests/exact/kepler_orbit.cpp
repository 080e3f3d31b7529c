#include "mote/exact/kepler_orbit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace mote::test {
namespace {

using Big = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                          boost::multiprecision::et_off>;

const KeplerElements tilted{.gravitational_parameter = 2.5,
                            .semi_major_axis = 0.7,
                            .eccentricity = 0.6,
                            .direction = 0.8,
                            .time_of_pericentre = -0.3};

/// E of Kepler's equation for M from 0 to pi by bisection: nothing that the code under test knows.
Big bisected_anomaly(const Big& mean, const Big& e) {
  Big lower = 0, upper = 4;
  for (int k = 0; k < 170; ++k) {
    const Big middle = (lower + upper) / 2;
    (middle - e * sin(middle) < mean ? lower : upper) = middle;
  }
  return lower;
}

struct BigState {
  std::array<Big, 2> position, velocity;
};

/// The orbit's state with 50 digits, for times from pericentre to the next.
BigState big_state(const KeplerElements& of, double time) {
  const Big e = of.eccentricity, a = of.semi_major_axis;
  const Big n = sqrt(Big(of.gravitational_parameter) / (a * a * a));
  const Big two_pi = 2 * boost::math::constants::pi<Big>();
  const Big mean = n * (Big(time) - Big(of.time_of_pericentre));
  const Big reduced = mean - two_pi * floor(mean / two_pi);
  const bool falling = reduced > two_pi / 2;
  const Big half = bisected_anomaly(falling ? two_pi - reduced : reduced, e);
  const Big anomaly = falling ? two_pi - half : half, axes = sqrt(1 - e * e);
  const Big c = cos(Big(of.direction)), s = sin(Big(of.direction));
  const auto turned = [&](const Big& x, const Big& y) {
    return std::array<Big, 2>{c * x - s * y, s * x + c * y};
  };
  const Big speed = a * n / (1 - e * cos(anomaly));
  return {turned(a * (cos(anomaly) - e), a * axes * sin(anomaly)),
          turned(-speed * sin(anomaly), speed * axes * cos(anomaly))};
}

double distance(const std::array<double, 2>& value, const std::array<Big, 2>& exact) {
  const Big dx = value[0] - exact[0], dy = value[1] - exact[1];
  return static_cast<double>(
      sqrt((dx * dx + dy * dy) / (exact[0] * exact[0] + exact[1] * exact[1])));
}

/// The larger relative error of place and velocity.
double error(const KeplerElements& of, double time) {
  const OrbitState state = KeplerOrbit(of).at(time);
  const BigState exact = big_state(of, time);
  return std::max(distance(state.position, exact.position),
                  distance(state.velocity, exact.velocity));
}

constexpr double unit = std::numeric_limits<double>::epsilon();

/// Two units in the last place, and what the rounding of the mean anomaly does to the state.
double allowed_error(const KeplerElements& of, double time) {
  const OrbitState state = KeplerOrbit(of).at(time);
  const auto size = [](const std::array<double, 2>& v) { return std::hypot(v[0], v[1]); };
  const double fastest = std::max(size(state.velocity) / size(state.position),
                                  size(state.acceleration) / size(state.velocity));
  return 2 * unit + 2e-19 * std::abs(time - of.time_of_pericentre) * fastest;
}

TEST(KeplerOrbit, IsRightToTheLastPlaces) {
  for (const double e : {0.0, 0.05, 0.5, 0.9, 63.0 / 64, 0.999999})
    for (const double time : {1e-12, 1e-6, 1e-3, 0.1, 1.0, 2.5, 3.14, 4.0, 6.0, 6.28, 6.2831853}) {
      const KeplerElements of{.eccentricity = e};
      EXPECT_LE(error(of, time), allowed_error(of, time)) << e << ' ' << time;
    }
}

TEST(KeplerOrbit, TurnsScalesAndGoesRoundManyTimes) {
  for (const double time : {-0.3, 0.1, 0.9, 1.9, 77.7, 12345.678, -5.5e4})
    EXPECT_LE(error(tilted, time), allowed_error(tilted, time)) << time;
}

TEST(KeplerOrbit, NoticesAWrongElement) {
  KeplerElements wrong = tilted;
  wrong.eccentricity *= 1 + 1e-14;
  const OrbitState state = KeplerOrbit(wrong).at(1.9);
  EXPECT_GT(distance(state.position, big_state(tilted, 1.9).position), 4 * unit);
}

TEST(KeplerOrbit, FallsByTheInverseSquare) {
  const OrbitState state = KeplerOrbit(tilted).at(1.1);
  const double r = std::hypot(state.position[0], state.position[1]);
  for (std::size_t d = 0; d < 2; ++d)
    EXPECT_NEAR(state.acceleration[d], -2.5 * state.position[d] / (r * r * r), 1e-14);
}

TEST(KeplerOrbit, HasAPeriod) {
  EXPECT_DOUBLE_EQ(KeplerOrbit(tilted).period(),
                   2 * std::numbers::pi * std::sqrt(0.7 * 0.7 * 0.7 / 2.5));
}

TEST(KeplerOrbit, SolvesKeplersEquationNextToAParabola) {
  for (const double e : {0.9999, 1 - 1e-12})
    for (const double mean : {1e-300, 1e-20, 1e-9, 1e-3, 1.0, 3.0}) {
      const Big exact = bisected_anomaly(mean, e);
      const Big found = eccentric_anomaly(mean, e);
      if (mean > 1e-20) {  // below that, bisection to 1e-50 is too coarse
        EXPECT_LE(abs(found / exact - 1), Big(2 * unit)) << e << ' ' << mean;
      }
      EXPECT_EQ(eccentric_anomaly(-mean, e), -eccentric_anomaly(mean, e));
    }
}

TEST(KeplerOrbit, RefusesWhatIsNoEllipse) {
  for (const double e : {-0.1, 1.0, 2.0, std::nan("")})
    EXPECT_THROW(KeplerOrbit({.eccentricity = e}), std::domain_error) << e;
  EXPECT_THROW(KeplerOrbit({.semi_major_axis = -1}), std::domain_error);
  EXPECT_THROW(KeplerOrbit({.gravitational_parameter = 0}), std::domain_error);
}

}  // namespace
}  // namespace mote::test
