// Flows with a free surface: rest, standing waves, the stretching drop and the turning square.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "flow_residual.hpp"
#include "mote/exact/elliptical_drop.hpp"
#include "mote/exact/hydrostatic.hpp"
#include "mote/exact/rotating_square_patch.hpp"
#include "mote/exact/standing_wave.hpp"
#include "support/quadrature.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

TEST(Hydrostatic, PressureIsTheWeightAbove) {
  const Hydrostatic water(1000, {0, -9.81, 0}, {0, 0.6, 0});
  const double places[] = {0.3, 0.6, 0.1, 0.1};
  const Table table = water.at_places(places, 2, 3);
  EXPECT_EQ(table[2].name, "pressure");
  EXPECT_NEAR(table[2].values[0], 0, 1e-12);
  EXPECT_NEAR(table[2].values[1], 1000 * 9.81 * 0.5, 1e-9);
  EXPECT_EQ(table[1].values[1], 0);
}

constexpr WaveTank tank{.density = 2,
                        .gravity = 1.5,
                        .bottom = -3,
                        .depth = 0.7,
                        .wave_number = 4,
                        .phase = 0.4,
                        .elevation = 0.01,
                        .rise = 0.03};

TEST(StandingWave, SolvesTheLinearEquations) {
  const FlowConstants water{.density = 2, .force = {0, -1.5}, .linear = true};
  for (const double t : {0.3, 2.1})
    EXPECT_LT(flow_residual(StandingWave(tank), water, 0.3, -2.5, t), 1e-7) << t;
}

TEST(StandingWave, CheckNoticesAnotherFrequency) {
  WaveTank wrong = tank;
  wrong.gravity = 1.6;
  const FlowConstants water{.density = 2, .force = {0, -1.5}, .linear = true};
  EXPECT_GT(flow_residual(StandingWave(wrong), water, 0.3, -2.5, 0.3), 1e-3);
}

TEST(StandingWave, FollowsItsSurfaceAndItsBottom) {
  const StandingWave wave(tank);
  const double x = 0.3, t = 1.7, h = 1e-5;
  const double surface = -3 + 0.7;
  const double places[] = {x, surface, x, -3};
  const Table table = wave.at_places(places, 2, t);
  const double rate = (wave.elevation(x, t + h) - wave.elevation(x, t - h)) / (2 * h);
  EXPECT_NEAR(table[1].values[0], rate, 1e-9);
  EXPECT_NEAR(table[1].values[1], 0, 1e-17);
  // On the surface at rest stands the weight of the water that has risen above it.
  EXPECT_NEAR(table[2].values[0], 2 * 1.5 * wave.elevation(x, t), 1e-12);
}

TEST(StandingWave, HasTheReferencePeriodAndDecay) {
  WaveTank half{.depth = 1, .wave_number = pi, .elevation = 0.1};
  EXPECT_NEAR(StandingWave(half).frequency(), 1.7691, 5e-5);
  half.viscosity = 0.01;
  const StandingWave wave(half);
  const double period = 2 * pi / wave.frequency();
  EXPECT_NEAR(wave.elevation(0, period), 0.1 * std::exp(-2 * 0.01 * pi * pi * period), 1e-15);
}

TEST(StandingWave, IsFiniteOnDeepWater) {
  const StandingWave wave({.depth = 1000, .wave_number = 10, .elevation = 0.01});
  const double places[] = {0.3, 999.9, 0.3, 0};
  const Table table = wave.at_places(places, 2, 0.2);
  for (const Column& column : table)
    for (const double value : column.values) EXPECT_TRUE(std::isfinite(value));
}

TEST(EllipticalDrop, HasTheReferenceSemiAxes) {
  const EllipticalDrop drop({1, 1, 100});
  for (const auto& [time, longer, shorter] : {std::array{0.0008, 1.0831, 0.9233},
                                              {0.0038, 1.4392, 0.6948},
                                              {0.0076, 1.9445, 0.5143},
                                              {0.0082, 2.0268, 0.4934}}) {
    EXPECT_NEAR(drop.shape(time).semi_axis_x, longer, 5e-5);
    EXPECT_NEAR(drop.shape(time).semi_axis_y, shorter, 5e-5);
  }
}

/// Energy keeps A^2 (a^2 + b^2), so a' = A a takes the time in which a comes from 1 to here.
TEST(EllipticalDrop, TakesTheTimeThatItsEnergyAllows) {
  const double time = 0.0076;
  const auto [a, b, rate] = EllipticalDrop({1, 1, 100}).shape(time);
  const auto slowness = [](long double q) { return std::sqrt((q * q + 1 / (q * q)) / 2) / q; };
  EXPECT_NEAR(static_cast<double>(panel_integral(slowness, 1, a)) / 100, time, 1e-14);
  EXPECT_NEAR(a * b, 1, 1e-14);
  EXPECT_NEAR(rate * rate * (a * a + b * b), 2e4, 1e-8);
}

TEST(EllipticalDrop, SolvesEulersEquations) {
  for (const double rate : {1.0, -1.0}) {
    const EllipticalDrop drop({1.2, 0.9, rate, 3, {0.1, 0.2}});
    EXPECT_LT(flow_residual(drop, {.density = 3}, 0.4, 0.3, 0.5), 1e-7) << rate;
    EXPECT_GT(flow_residual(drop, {.density = 3.01}, 0.4, 0.3, 0.5), 1e-4) << rate;
  }
}

TEST(EllipticalDrop, HasNoPressureOnItsSurface) {
  const EllipticalDrop drop({1, 1, 2});
  const auto [a, b, rate] = drop.shape(0.4);
  const double places[] = {0.6 * a, 0.8 * b};
  EXPECT_NEAR(drop.at_places(places, 2, 0.4)[2].values[0], 0, 1e-14);
}

TEST(RotatingSquarePatch, IsItsDoubleSeries) {
  for (const auto& [x, y] : {std::array{0.5, 0.5}, {0.1, 0.3}, {0.02, 0.97}}) {
    double sum = 0;
    for (int m = 1; m < 1000; m += 2)
      for (int n = 1; n < 1000; n += 2)
        sum -= 32 * std::sin(m * pi * x) * std::sin(n * pi * y) /
               (std::pow(pi, 4) * m * n * (1.0 * m * m + 1.0 * n * n));
    // The first terms left out are 32/(pi^4 1000^3) with alternating signs.
    EXPECT_NEAR(rotating_square_patch_pressure(x, y), sum, 1e-8) << x << ", " << y;
  }
}

TEST(RotatingSquarePatch, HasTheReferenceValueAndItsSymmetries) {
  EXPECT_NEAR(rotating_square_patch_pressure(0.5, 0.5), -0.14734, 5e-6);
  const double value = rotating_square_patch_pressure(0.2, 0.35);
  EXPECT_NEAR(rotating_square_patch_pressure(0.35, 0.2), value, 1e-15);
  EXPECT_NEAR(rotating_square_patch_pressure(0.8, 0.65), value, 1e-15);
  EXPECT_EQ(rotating_square_patch_pressure(0, 0.3), 0);
  EXPECT_TRUE(std::isnan(rotating_square_patch_pressure(1.1, 0.3)));
}

TEST(RotatingSquarePatch, HasTheLaplacianOfATurningFlow) {
  const double x = 0.3, y = 0.22, h = 1e-3;
  const auto p = [](double a, double b) { return rotating_square_patch_pressure(a, b); };
  const double laplacian =
      (p(x + h, y) + p(x - h, y) + p(x, y + h) + p(x, y - h) - 4 * p(x, y)) / (h * h);
  EXPECT_NEAR(laplacian, 2, 1e-4);
}

}  // namespace
}  // namespace mote::test
