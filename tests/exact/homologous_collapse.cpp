#include "mote/exact/homologous_collapse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace mote::test {
namespace {

using std::numbers::pi;

const ColdBall falling{.gravitational_constant = 2,
                       .mass = 3,
                       .radius = 1.5,
                       .centre = {1, 0, -1},
                       .velocity = {0.2, 0, 0},
                       .position = {1.3, 0.4, -1.2}};

/// The equation f'' = -G M/(R^3 f^2), by differences, relative.
double residual(const HomologousCollapse& collapse, double time, double pull) {
  constexpr double step = 1e-4;
  const double f = collapse.contraction(time);
  const double second =
      (collapse.contraction(time + step) - 2 * f + collapse.contraction(time - step)) /
      (step * step);
  return std::abs(second / (-pull / (f * f)) - 1);
}

TEST(ColdCollapse, SolvesTheEquationOfAShell) {
  const HomologousCollapse collapse(falling);
  const double pull = 2 * 3 / std::pow(1.5, 3), end = collapse.valid_until();
  EXPECT_NEAR(end, pi / 2 / std::sqrt(2 * pull), 1e-15);
  for (const double part : {0.1, 0.5, 0.9}) {
    EXPECT_LT(residual(collapse, part * end, pull), 1e-5);
    EXPECT_GT(residual(collapse, part * end, 1.001 * pull), 5e-4);  // negative control
  }
  EXPECT_EQ(collapse.contraction(0), 1);
  EXPECT_EQ(collapse.contraction_rate(0), 0);
  EXPECT_LT(collapse.contraction(end), 1e-9);
  EXPECT_THROW((void)collapse.contraction(1.01 * end), std::domain_error);
}

/// One place: where it is, its velocity, and the velocity by the place.
TEST(ColdCollapse, MovesItsBodiesWithTheirVelocities) {
  const HomologousCollapse collapse(falling);
  constexpr double step = 1e-5;
  const double time = 0.6 * collapse.valid_until();
  const Table before = collapse.of_particles(time - step),
              after = collapse.of_particles(time + step);
  const Table now = collapse.of_particles(time);
  const double place[] = {now[0].values[0], now[1].values[0], now[2].values[0]};
  const Table there = collapse.at_places(place, 3, time);
  for (std::size_t d = 0; d < 3; ++d) {
    const double rate = (after[d].values[0] - before[d].values[0]) / (2 * step);
    EXPECT_NEAR(now[d + 3].values[0], rate, 1e-8);
    EXPECT_NEAR(there[d].values[0], rate, 1e-8);
  }
}

}  // namespace
}  // namespace mote::test
