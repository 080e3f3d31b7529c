#include "mote/operators/differential/finite_difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "support/agreement.hpp"
#include "support/altered_operator.hpp"
#include "support/clouds.hpp"
#include "support/derivatives.hpp"

namespace mote::test {
namespace {

/// Uneven points of which all but the two at the ends are receivers.
Points<1> uneven_points() {
  auto points = jittered_cloud<1>({.side = 20, .jitter = 0.4});
  points.receivers = points.size() - 2;
  for (double& x : points.position) x -= 10;
  const auto& x = points.position;
  const auto swap_in = [&](auto found, std::size_t place) {
    std::swap(points.position[place], points.position[found - x.begin()]);
  };
  swap_in(std::ranges::min_element(x), x.size() - 2);
  swap_in(std::ranges::max_element(x), x.size() - 1);
  return points;
}

/// Whether gradient, divergence and Laplacian of 2 - 3 x + c x^2 are exact, to 1e-12.
testing::AssertionResult is_exact(DifferentialOperator<1>& op, const Points<1>& points, double c) {
  std::vector<double> parabola, gradient, laplacian;
  for (const double x : points.position) parabola.push_back(2 - 3 * x + c * x * x);
  for (Index i = 0; i < points.receivers; ++i) {
    gradient.push_back(-3 + 2 * c * points.position[i]);
    laplacian.push_back(2 * c);
  }
  const auto found = derivatives_of<1>(op, points, parabola, parabola);
  if (const auto right = agree(found.gradient, gradient, 1e-12); !right) return right;
  if (const auto right = agree(found.divergence, gradient, 1e-12); !right) return right;
  return agree(found.laplacian, laplacian, 1e-12);
}

TEST(FiniteDifference, IsExactForParabolasOnUnevenPoints) {
  FiniteDifference<1> op;
  EXPECT_TRUE(is_exact(op, uneven_points(), 0.5));
  EXPECT_TRUE(is_exact(op, uneven_points(), -4));
}

TEST(FiniteDifference, CheckNoticesOneAlteredWeight) {
  AlteredOperator<1, FiniteDifference<1>> altered({}, 5, 1e-6);
  EXPECT_FALSE(is_exact(altered, uneven_points(), 0.5));
}

TEST(FiniteDifference, HasTheUsualWeightsOnARegularLine) {
  auto inner = line_points({0.5, 0, 1});
  inner.receivers = 1;
  FiniteDifference<1> op;
  const NeighbourLists lists({{1, 2}});
  op.prepare(inner, lists);
  Vec<1> gradient[2];
  double laplacian[2];
  op.gradient_weights(0, gradient);
  op.laplacian_weights(0, laplacian);
  EXPECT_DOUBLE_EQ(gradient[0][0], -1);
  EXPECT_DOUBLE_EQ(gradient[1][0], 1);
  EXPECT_DOUBLE_EQ(laplacian[0], 4);
  EXPECT_DOUBLE_EQ(laplacian[1], 4);
}

/// Expects that finite differences refuse these points because of this particle.
void expect_refusal(const Points<1>& points, Index particle) {
  FiniteDifference<1> op;
  try {
    op.prepare(points, brute_force(points, op.neighbour_rule()));
    FAIL() << "the operator accepts these points";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.particles(), testing::ElementsAre(particle));
    EXPECT_THAT(failure.what(),
                testing::HasSubstr("particle " + std::to_string(particle) + " has no point on"));
  }
}

TEST(FiniteDifference, RefusesOneSidedParticlesByName) {
  expect_refusal(line_points({0, 1, 2, 3}), 0);
  auto upper = line_points({1, 2, 3, 0});
  upper.receivers = 3;
  expect_refusal(upper, 2);
  expect_refusal(line_points({0}), 0);
}

TEST(FiniteDifference, RefusesCoincidentParticlesByName) {
  auto points = line_points({1, 2, 2, 3, 0, 4});
  points.receivers = 4;
  expect_refusal(points, 1);
}

}  // namespace
}  // namespace mote::test
