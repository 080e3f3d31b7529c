#include "mote/exact/kepler_pair.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace mote::test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using State = std::array<Real, 12>;  // position and velocity of the one, and of the other

/// Two bodies of these masses whose separation is on an ellipse in a tilted plane, at an anomaly E,
/// with a centre of mass that moves; mu = G (m_1 + m_2) = 2.
TwoBodies orbit(double eccentricity, double anomaly, std::array<double, 2> mass) {
  const double axis = 1.5, parameter = 2, e = eccentricity, minor = std::sqrt(1 - e * e);
  const double rate = std::sqrt(parameter / axis) / axis / (1 - e * std::cos(anomaly));
  const double in_plane[2][2] = {
      {axis * (std::cos(anomaly) - e), axis * minor * std::sin(anomaly)},
      {-axis * rate * std::sin(anomaly), axis * minor * rate * std::cos(anomaly)}};
  const double first[] = {0.6, 0.0, 0.8}, second[] = {0.48, 0.8, -0.36};
  TwoBodies bodies{.gravitational_constant = parameter / (mass[0] + mass[1]), .mass = mass};
  const double share[] = {-mass[1] / (mass[0] + mass[1]), mass[0] / (mass[0] + mass[1])};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t d = 0; d < 3; ++d) {
      const auto part = [&](const double(&v)[2]) {
        return share[k] * (v[0] * first[d] + v[1] * second[d]);
      };
      bodies.position[k][d] = part(in_plane[0]) + 0.25 * static_cast<double>(d);
      bodies.velocity[k][d] = part(in_plane[1]) - 0.125 * static_cast<double>(d + 1);
    }
  return bodies;
}

State state_of(const TwoBodies& bodies) {
  State state;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t d = 0; d < 3; ++d) {
      state[6 * k + d] = bodies.position[k][d];
      state[6 * k + 3 + d] = bodies.velocity[k][d];
    }
  return state;
}

/// Another way altogether: the power series of Newton's equations in 50 digits, order by order.
/// With s = r^2 and w = s^(-3/2), so that s w' = -3/2 s' w, the products of series give
///   (k + 1) x_(k+1) = v_k,  (k + 1) v_(k+1) = sum of w_j x_(k-j),
///   k s_0 w_k = sum over j = 1 ... k of (-3/2 j - (k - j)) s_j w_(k-j).
State series_step(const TwoBodies& bodies, const State& start, const Real& step) {
  constexpr std::size_t order = 30;
  std::vector<State> term{start};
  std::vector<Real> s, w;
  for (std::size_t k = 0; k < order; ++k) {
    const auto separation = [&](std::size_t n, std::size_t d) -> Real {
      return term[n][6 + d] - term[n][d];
    };
    Real square = 0;
    for (std::size_t j = 0; j <= k; ++j)
      for (std::size_t d = 0; d < 3; ++d) square += separation(j, d) * separation(k - j, d);
    s.push_back(square);
    Real power = k == 0 ? Real(1 / (s[0] * sqrt(s[0]))) : Real(0);
    for (std::size_t j = 1; j <= k; ++j)
      power += (-1.5 * static_cast<double>(j) - static_cast<double>(k - j)) * s[j] * w[k - j] /
               (static_cast<double>(k) * s[0]);
    w.push_back(power);
    State next;
    for (std::size_t d = 0; d < 3; ++d) {
      Real pull = 0;
      for (std::size_t j = 0; j <= k; ++j) pull += w[j] * separation(k - j, d);
      pull *= bodies.gravitational_constant;
      for (std::size_t body = 0; body < 2; ++body) {
        next[6 * body + d] = term[k][6 * body + 3 + d] / static_cast<double>(k + 1);
        next[6 * body + 3 + d] =
            pull * (body == 0 ? bodies.mass[1] : -bodies.mass[0]) / static_cast<double>(k + 1);
      }
    }
    term.push_back(next);
  }
  State end = term.back();
  for (std::size_t k = order; k-- > 0;)
    for (std::size_t c = 0; c < end.size(); ++c) end[c] = end[c] * step + term[k][c];
  return end;
}

/// Largest error against the series at this time, over the largest value.
double error_after(const TwoBodies& bodies, double time, int steps) {
  State state = state_of(bodies);
  for (int k = 0; k < steps; ++k) state = series_step(bodies, state, Real(time) / steps);
  const Table table = KeplerPair(bodies).of_particles(time);
  double worst = 0, largest = 0;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t c = 0; c < 6; ++c) {
      const Real& expected = state[6 * k + c];
      worst = std::max(worst, std::abs(static_cast<double>(table[c].values[k] - expected)));
      largest = std::max(largest, std::abs(static_cast<double>(expected)));
    }
  return worst / largest;
}

TEST(KeplerPair, IsThePowerSeriesOfNewtonsEquations) {
  struct Case {
    double anomaly;
    std::array<double, 2> mass;
  };
  for (const auto& [anomaly, mass] :
       {Case{0, {1, 1}}, {0.5, {3, 0.001}}, {-2, {0, 2}}, {std::numbers::pi, {2, 0}}}) {
    EXPECT_LT(error_after(orbit(0, anomaly, mass), 3, 6), 2e-15);
    EXPECT_LT(error_after(orbit(0.3, anomaly, mass), 3, 12), 2e-15);
    EXPECT_LT(error_after(orbit(0.9, anomaly, mass), 1, 100), 2e-14);
  }
}

TEST(KeplerPair, IsNotTheSeriesOfOtherBodies) {  // negative control
  TwoBodies bodies = orbit(0.3, 0.5, {1, 1});
  const Table before = KeplerPair(bodies).of_particles(3);
  bodies.velocity[1][0] *= 1 + 1e-6;
  EXPECT_GT(std::abs(KeplerPair(bodies).of_particles(3)[0].values[1] / before[0].values[1] - 1),
            1e-7);
}

/// What rounding of the state does, grows with 1/(1 - e).
TEST(KeplerPair, KnowsItsElements) {
  for (const double e : {0.0, 0.5, 63.0 / 64, 0.9999}) {
    const KeplerPair pair(orbit(e, 1, {1, 1}));
    EXPECT_NEAR(pair.eccentricity(), e, 1e-15);
    EXPECT_NEAR(pair.semi_major_axis(), 1.5, 1e-14);
    EXPECT_NEAR(pair.period(), 2 * std::numbers::pi * std::sqrt(1.5 * 1.5 * 1.5 / 2), 3e-14);
  }
}

TEST(KeplerPair, StartsWhereItsBodiesDo) {
  for (const double e : {0.0, 0.5, 0.99}) {
    const TwoBodies bodies = orbit(e, 0.7, {1, 2});
    const Table start = KeplerPair(bodies).of_particles(0);
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(start[d].values[k], bodies.position[k][d], 1e-14);
        EXPECT_NEAR(start[d + 3].values[k], bodies.velocity[k][d], 1e-13);
      }
  }
}

TEST(KeplerPair, NeedsAnEllipse) {
  TwoBodies bodies{.mass = {1, 0}};
  bodies.position[1] = {1, 0, 0};
  EXPECT_THROW(KeplerPair{bodies}, std::domain_error);  // falls on a line
  bodies.velocity[1] = {0, 1.4, 0};
  EXPECT_NO_THROW(KeplerPair{bodies});
  bodies.velocity[1] = {0, 1.5, 0};  // above sqrt(2)
  EXPECT_THROW(KeplerPair{bodies}, std::domain_error);
}

}  // namespace
}  // namespace mote::test
