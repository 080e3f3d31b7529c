// Flows between two walls from rest, against their series summed plainly in long double, and
// against values that were found elsewhere.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "flow_residual.hpp"
#include "mote/exact/couette_start.hpp"
#include "mote/exact/poiseuille_start.hpp"

namespace mote::test {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

/// What it leaves out is at most the next term, 5e-18, over 2 sin(pi y): 8e-16 at y = 0.001.
long double plain_poiseuille(long double y, long double time) {
  long double speed = 0;
  for (long n = 300001; n > 0; n -= 2) {
    const long double wave = static_cast<long double>(n) * pi;
    speed += 4 / (wave * wave * wave) * std::sin(wave * y) * -std::expm1(-wave * wave * time);
  }
  return speed;
}

long double plain_couette(long double y, long double time) {
  long double speed = y;
  for (long n = 400; n > 0; --n) {
    const long double wave = static_cast<long double>(n) * pi;
    speed += (n % 2 == 0 ? 2 : -2) / wave * std::sin(wave * y) * std::exp(-wave * wave * time);
  }
  return speed;
}

TEST(PoiseuilleStart, IsItsSeriesAtAllTimes) {
  for (const double time : {1e-6, 1e-3, 0.0499, 0.0501, 0.3, 4.0})
    for (const double y : {0.001, 0.2, 0.5, 0.93})
      EXPECT_NEAR(poiseuille_start(y, time, 1, 1), static_cast<double>(plain_poiseuille(y, time)),
                  1e-15)
          << time << ", " << y;
}

TEST(PoiseuilleStart, SeriesCheckNoticesAnotherTime) {
  EXPECT_GT(std::abs(poiseuille_start(0.5, 0.05 * (1 + 1e-10), 1, 1) -
                     static_cast<double>(plain_poiseuille(0.5, 0.05))),
            1e-13);
}

TEST(PoiseuilleStart, HasTheReferenceValues) {
  for (const auto& [time, speed] : {std::array{0.0225, 4.465e-6},
                                    {0.045, 8.469e-6},
                                    {0.1125, 1.65e-5},
                                    {0.225, 2.22e-5},
                                    {1.0, 2.49987e-5}})
    EXPECT_NEAR(2e-4 * poiseuille_start(0.5e-3, time, 1e-3, 1e-6), speed, 5e-4 * speed);
}

TEST(PoiseuilleStart, RunsAlongTheWallsFromTheLowerOne) {
  const PoiseuilleStart flow({1, -2, 2}, {3, 0, 0}, 0.5);
  const double places[] = {7, -2, 8, 0, 9, 2};
  const Table table = flow.at_places(places, 2, 1000);
  ASSERT_EQ(table.size(), 2u);
  EXPECT_NEAR(table[0].values[1], 3 * 4.0 * 4.0 / (8 * 0.5), 1e-13);
  EXPECT_NEAR(table[0].values[0], 0, 1e-15);
  EXPECT_NEAR(table[0].values[2], 0, 1e-15);
  EXPECT_EQ(table[1].values[1], 0);
}

TEST(PoiseuilleStart, SolvesItsEquation) {
  const PoiseuilleStart flow({1, 0, 1}, {3, 0, 0}, 0.5);
  const FlowConstants fluid{.viscosity = 0.5, .force = {3, 0}};
  for (const double t : {0.02, 0.3}) EXPECT_LT(flow_residual(flow, fluid, 0, 0.3, t), 1e-6) << t;
}

TEST(CouetteStart, IsItsSeriesAtAllTimes) {
  for (const double time : {1e-3, 0.0499, 0.0501, 0.3, 4.0})
    for (const double y : {0.001, 0.2, 0.5, 0.93})
      EXPECT_NEAR(couette_start(y, time, 1, 1), static_cast<double>(plain_couette(y, time)), 2e-15)
          << time << ", " << y;
}

TEST(CouetteStart, HasTheReferenceValues) {
  for (const auto& [time, speed] : {std::array{0.0225, 2.303e-7},
                                    {0.045, 1.1948e-6},
                                    {0.1125, 3.6284e-6},
                                    {0.225, 5.3863e-6},
                                    {1.0, 6.2496e-6}})
    EXPECT_NEAR(1.25e-5 * couette_start(0.5e-3, time, 1e-3, 1e-6), speed, 5e-4 * speed);
}

TEST(CouetteStart, EachWallDragsTheFluid) {
  const CouetteStart flow({0, 1, 3}, {{0, 2, 0}, {0, 0, -4}}, 0.1);
  const double places[] = {1, 5, 5, 2, 5, 5, 3, 5, 5};
  const Table table = flow.at_places(places, 3, 1e4);
  ASSERT_EQ(table.size(), 3u);
  for (const auto& [row, v, w] : {std::array{0, 2, 0}, {1, 1, -2}, {2, 0, -4}}) {
    EXPECT_NEAR(table[1].values[static_cast<std::size_t>(row)], v, 1e-14);
    EXPECT_NEAR(table[2].values[static_cast<std::size_t>(row)], w, 1e-14);
  }
}

TEST(CouetteStart, IsAtRestUntilItStarts) {
  EXPECT_EQ(couette_start(0.5, 0, 1, 1), 0);
  EXPECT_EQ(poiseuille_start(0.5, 0, 1, 1), 0);
}

}  // namespace
}  // namespace mote::test
