#include "mote/integrators/runge_kutta_8.hpp"

#include <gtest/gtest.h>

#include <array>

#include "systems.hpp"

namespace mote::test {
namespace {

/// Place and velocity of x'' = -x, from x = 1 at rest, after a step of 1: the first column of the
/// ContEvol paper's (2.2.18), with this coefficient of the fourth power, where it has 1397/33600.
std::array<double, 2> propagated(double fourth) {
  return {1 - 1.0 / 2 + fourth - 1.0 / 720 + 1.0 / 40320 - 1.0 / 2177280,
          -1 + 1.0 / 6 - 1.0 / 120 + 1.0 / 5040 - 1.0 / 2177280};
}

TEST(RungeKutta8, HasThePapersPropagatorCorrected) {
  Body oscillator(1, [](double place) { return -place; });
  RungeKutta8().advance_one_step(oscillator, 0, 1);
  const auto corrected = propagated(1.0 / 24), printed = propagated(1397.0 / 33600);
  EXPECT_NEAR(oscillator.place(), corrected[0], 4e-15);
  EXPECT_NEAR(oscillator.velocity(), corrected[1], 4e-15);
  EXPECT_GT(std::abs(oscillator.place() - printed[0]), 8e-5);
}

}  // namespace
}  // namespace mote::test
