// Distances of the shapes, against what a ruler gives.

#include <gmock/gmock.h>

#include <cmath>

#include "mote/geometry/ball.hpp"
#include "mote/geometry/box.hpp"
#include "mote/geometry/combined_shapes.hpp"
#include "mote/geometry/formula_shape.hpp"
#include "mote/geometry/polygon.hpp"
#include "support/random.hpp"

namespace mote {
namespace {

using testing::HasSubstr;

constexpr double endless = Extent::endless;

TEST(Box, DistanceIsToTheNearestSideEdgeOrCorner) {
  const Box box({{0, 0, 0}, {4, 2, 1}});
  EXPECT_DOUBLE_EQ(box.distance({2, 1, 0.25}), -0.25);
  EXPECT_DOUBLE_EQ(box.distance({5, 1, 0.5}), 1);
  EXPECT_DOUBLE_EQ(box.distance({7, 6, 0.5}), 5);
  EXPECT_DOUBLE_EQ(box.distance({5, 4, 3}), 3);
  EXPECT_EQ(box.distance({4, 1, 0.5}), 0);
}

TEST(Box, MayGoOnWithoutEnd) {
  const Box channel({{-endless, 0, -endless}, {endless, 2, endless}});
  EXPECT_DOUBLE_EQ(channel.distance({1e9, 0.5, 0}), -0.5);
  EXPECT_DOUBLE_EQ(channel.distance({-3, 5, 7}), 3);
}

TEST(Ball, DistanceIsFromTheSphere) {
  const Ball ball({1, 2, 3}, 2);
  EXPECT_DOUBLE_EQ(ball.distance({1, 2, 3}), -2);
  EXPECT_DOUBLE_EQ(ball.distance({1, 5, 7}), 3);
}

/// An L of width 1 in a square of side 2.
Polygon l_shape(double bottom = -endless, double top = endless) {
  return {{0, 2, 2, 1, 1, 0}, {0, 0, 1, 1, 2, 2}, bottom, top};
}

TEST(Polygon, DistanceIsToTheNearestEdgeOrCorner) {
  EXPECT_DOUBLE_EQ(l_shape().distance({0.5, 1.75, 0}), -0.25);
  EXPECT_DOUBLE_EQ(l_shape().distance({0.75, 0.75, 0}), -std::hypot(0.25, 0.25));
  EXPECT_DOUBLE_EQ(l_shape().distance({1.5, 1.75, 0}), 0.5);
  EXPECT_DOUBLE_EQ(l_shape().distance({5, -4, 0}), 5);
}

TEST(Polygon, IsTheSameEitherWayRound) {
  const Polygon reversed({0, 1, 1, 2, 2, 0}, {2, 2, 1, 1, 0, 0});
  test::Draws draws(1);
  for (int k = 0; k < 100; ++k) {
    const Triple place{draws.uniform(-1, 3), draws.uniform(-1, 3), 0};
    EXPECT_DOUBLE_EQ(reversed.distance(place), l_shape().distance(place));
  }
}

TEST(Polygon, OfABoxIsTheBox) {
  const Polygon polygon({0, 4, 4, 0}, {0, 0, 2, 2}, 0, 1);
  const Box box({{0, 0, 0}, {4, 2, 1}});
  test::Draws draws(2);
  for (int k = 0; k < 1000; ++k) {
    const Triple place{draws.uniform(-1, 5), draws.uniform(-1, 3), draws.uniform(-1, 2)};
    EXPECT_NEAR(polygon.distance(place), box.distance(place), 1e-14);
  }
}

TEST(Polygon, HasNoProblemIfItIsOne) {
  EXPECT_EQ(polygon_problem({0, 2, 2, 1, 1, 0}, {0, 0, 1, 1, 2, 2}), "");
  EXPECT_EQ(polygon_problem({0, 1, 0}, {0, 0, 1}), "");
  EXPECT_EQ(polygon_problem({0, 1, 2, 2, 0}, {0, 0, 0, 1, 1}), "");  // a corner on a straight side
}

TEST(Polygon, SaysWhatKeepsCornersFromBeingOne) {
  EXPECT_THAT(polygon_problem({0, 1}, {0, 1}), HasSubstr("at least 3 corners, and has 2"));
  EXPECT_THAT(polygon_problem({0, 1, 2}, {0, 1}), HasSubstr("has 3 and 2"));
  EXPECT_THAT(polygon_problem({0, 1, 1, 0}, {0, 1, 0, 1}), HasSubstr("crosses itself"));
  EXPECT_THAT(polygon_problem({0, 1, 1, 1}, {0, 0, 0, 1}), HasSubstr("twice running: (1, 0)"));
  EXPECT_THAT(polygon_problem({0, 2, 1}, {0, 0, 0}), HasSubstr("turns back on itself at (2, 0)"));
  // a corner on another edge
  EXPECT_THAT(polygon_problem({0, 4, 4, 2, 0}, {0, 0, 2, 0, 2}), HasSubstr("crosses itself"));
}

TEST(FormulaShape, OfALinearFormulaIsExact) {
  const FormulaShape half_space([](const Triple& p) { return 3 * p[0] + 4 * p[1] - 5; }, 2, 1e-3);
  EXPECT_NEAR(half_space.distance({3, 4, 0}), -4, 1e-9);
  EXPECT_NEAR(half_space.distance({0, 0, 0}), 1, 1e-9);
  EXPECT_TRUE(half_space.holds({3, 4, 0}, 0));
  EXPECT_FALSE(half_space.holds({0, 0, 0}, 0));
}

TEST(FormulaShape, NearACurvedSurfaceIsOfSecondOrder) {
  const FormulaShape disc([](const Triple& p) { return 1 - p[0] * p[0] - p[1] * p[1]; }, 2, 1e-4);
  const double coarse = std::abs(disc.distance({0.8, 0, 0}) + 0.2);
  const double fine = std::abs(disc.distance({0.9, 0, 0}) + 0.1);
  const double order = std::log2(coarse / fine);
  EXPECT_GT(order, 1.9);
  EXPECT_LT(order, 2.4);
}

TEST(FormulaShape, WithoutASlopeHasNoDistance) {
  const FormulaShape step([](const Triple& p) { return p[0] > 0 ? 1 : -1; }, 2, 1e-4);
  EXPECT_TRUE(std::isinf(step.distance({1, 0, 0})));
}

TEST(CombinedShapes, TakeTogetherAndLeaveOut) {
  const auto box = std::make_shared<Box>(Extent{{0, 0, -endless}, {4, 4, endless}});
  const auto disc = std::make_shared<Ball>(Triple{4, 2, 0}, 1);
  const Union both({box, disc});
  const Difference bitten(box, disc);
  EXPECT_DOUBLE_EQ(both.distance({6, 2, 0}), 1);
  EXPECT_DOUBLE_EQ(both.distance({1, 2, 0}), -1);
  EXPECT_DOUBLE_EQ(bitten.distance({3.5, 2, 0}), 0.5);
  EXPECT_DOUBLE_EQ(bitten.distance({2.5, 2, 0}), -0.5);
  EXPECT_EQ(both.extent().upper[0], 5);
  EXPECT_EQ(bitten.extent().upper[0], 4);
}

TEST(CombinedShapes, ADifferenceAndWhatItLeavesOutShareTheSpaceWithoutAGap) {
  const auto box = std::make_shared<Box>(Extent{{0, 0, -endless}, {4, 4, endless}});
  const auto inner = std::make_shared<Box>(Extent{{1, 1, -endless}, {2, 2, endless}});
  const Difference frame(box, inner);
  for (const double x : {1.0, 1.5, 2.0, 3.0})
    EXPECT_NE(frame.holds({x, 1.5, 0}, 1e-9), inner->holds({x, 1.5, 0}, 1e-9));
}

TEST(OutwardDirection, LeadsAwayFromTheNearestSurface) {
  const Box box({{0, 0, -endless}, {4, 2, endless}});
  EXPECT_THAT(outward_direction(box, {3.75, 1, 0}, 2, 1e-4), testing::ElementsAre(1, 0, 0));
  const Triple corner = outward_direction(box, {7, 6, 0}, 2, 1e-4);
  EXPECT_NEAR(corner[0], 0.6, 1e-6);
  EXPECT_NEAR(corner[1], 0.8, 1e-6);
}

TEST(OutwardDirection, IsAUnitVectorWhereTheDistanceHasAKink) {
  const Box plate({{0, 0, -endless}, {4, 2, endless}});
  const Ball ball({0, 0, 0}, 1);
  for (const Triple& d : {outward_direction(plate, {2, 1, 0}, 2, 1e-4),
                          outward_direction(plate, {0.25, 0.25, 0}, 2, 1e-4),
                          outward_direction(ball, {0, 0, 0}, 3, 1e-4)})
    EXPECT_NEAR(std::hypot(d[0], d[1], d[2]), 1, 1e-12);
}

}  // namespace
}  // namespace mote
