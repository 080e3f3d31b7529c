// Finite differences on lattices in 2 and 3 dimensions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mote/operators/differential/finite_difference.hpp"
#include "mote/particles/failure.hpp"
#include "support/altered_operator.hpp"
#include "support/polynomial.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A lattice of `side` points a direction at these spacings, in random order but for the receivers,
/// which come first: all points that are not on its faces. `growth` widens the spacings from one to
/// the next.
template <int D>
Points<D> lattice(Index side, const Vec<D>& spacing, double growth = 1) {
  const auto coordinate = [&](Index k, int d) {
    double x = 0;
    for (Index step = 0; step < k; ++step) x += spacing[d] * std::pow(growth, step);
    return x;
  };
  auto points = jittered_cloud<D>({.side = side, .jitter = 0, .variation = 0});
  points.receivers = 0;
  for (Index i = 0; i < points.size(); ++i) {
    const Vec<D> place = points.at(i);
    const bool inside = place.minCoeff() > 0 && place.maxCoeff() < side - 1;
    for (int d = 0; d < D; ++d)
      points.position[i * D + d] = coordinate(static_cast<Index>(place[d]), d);
    points.length[i] = std::pow(spacing.prod(), 1.0 / D);
    if (!inside) continue;
    for (int d = 0; d < D; ++d)
      std::swap(points.position[i * D + d], points.position[points.receivers * D + d]);
    ++points.receivers;
  }
  return points;
}

TEST(LatticeDifference, IsExactForParabolasAtDifferentSpacings) {
  for (const double ratio : {1.0, 0.4, 2.0, 3.0}) {
    FiniteDifference<2> op;
    EXPECT_TRUE(is_exact<2>(op, lattice<2>(7, {0.5, 0.5 * ratio}), 2, 1e-12)) << ratio;
  }
  for (const double ratio : {1.0, 0.5, 2.0}) {
    FiniteDifference<3> op;
    EXPECT_TRUE(is_exact<3>(op, lattice<3>(5, {0.5, 0.7, 0.5 * ratio}), 2, 1e-12)) << ratio;
  }
}

TEST(LatticeDifference, IsExactForParabolasOnSpacingsThatGrow) {
  FiniteDifference<2> plane;
  EXPECT_TRUE(is_exact<2>(plane, lattice<2>(5, {0.5, 0.6}, 1.05), 2, 1e-12));
  FiniteDifference<3> space;
  EXPECT_TRUE(is_exact<3>(space, lattice<3>(4, {0.5, 0.6, 0.7}, 1.05), 2, 1e-12));
}

// On a lattice the gradient's error is a third derivative, and the second derivatives' a fourth.
TEST(LatticeDifference, IsNotExactForQuartics) {
  FiniteDifference<2> plane;
  EXPECT_TRUE(is_nowhere_exact<2>(plane, lattice<2>(7, {0.5, 0.6}), 4, 1e-4));
  FiniteDifference<3> space;
  EXPECT_TRUE(is_nowhere_exact<3>(space, lattice<3>(5, {0.5, 0.6, 0.7}), 4, 1e-4));
}

TEST(LatticeDifference, CheckNoticesOneAlteredWeight) {
  AlteredOperator<2, FiniteDifference<2>> plane({}, 3, 1e-6);
  EXPECT_TRUE(is_nowhere_exact<2>(plane, lattice<2>(7, {0.5, 0.6}), 2, 1e-12));
  AlteredOperator<3, FiniteDifference<3>> space({}, 3, 1e-6);
  EXPECT_TRUE(is_nowhere_exact<3>(space, lattice<3>(5, {0.5, 0.6, 0.7}), 2, 1e-12));
}

TEST(LatticeDifference, HasTheNinePointMixedDerivative) {
  auto points = lattice<2>(3, {0.5, 0.25});
  FiniteDifference<2> op;
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  op.prepare(points, lists);
  std::vector<Mat<2>> weights(lists[0].size());
  op.hessian_weights(0, weights);
  ASSERT_EQ(weights.size(), 8u);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Vec<2> x = points.at(lists[0][k]) - points.at(0);
    EXPECT_DOUBLE_EQ(weights[k](0, 1), x.prod() / (4 * 0.5 * 0.5 * 0.25 * 0.25)) << x;
    EXPECT_DOUBLE_EQ(weights[k](0, 0), x[1] == 0 ? 4 : 0) << x;
  }
}

template <int D>
void expect_refusal(const Points<D>& points, Index particle) {
  FiniteDifference<D> op;
  try {
    op.prepare(points, brute_force(points, op.neighbour_rule()));
    FAIL() << "the operator accepts these points";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.particles(), ElementsAre(particle));
    EXPECT_THAT(failure.what(),
                HasSubstr("particle " + std::to_string(particle) + " has no point on each side"));
    EXPECT_THAT(failure.cause(), HasSubstr("the points of a lattice"));
  }
}

TEST(LatticeDifference, RefusesTheFirstParticleOnAFaceByName) {
  auto plane = lattice<2>(6, {0.5, 0.6});
  const Index inner = plane.receivers;
  plane.receivers = plane.size();
  expect_refusal(plane, inner);
  auto space = lattice<3>(4, {0.5, 0.6, 0.7});
  const Index inside = space.receivers;
  space.receivers = space.size();
  expect_refusal(space, inside);
}

TEST(LatticeDifference, RefusesAParticleOffTheLatticeByName) {
  auto plane = lattice<2>(6, {0.5, 0.5});
  plane.position[2 * 5] += 1e-3;
  plane.position[2 * 5 + 1] += 1e-3;
  expect_refusal(plane, 5);
  auto space = lattice<3>(5, {0.5, 0.5, 0.5});
  for (int d = 0; d < 3; ++d) space.position[3 * 4 + d] += 1e-3;
  expect_refusal(space, 4);
}

TEST(LatticeDifference, TakesPositionsThatAreRounded) {
  auto points = lattice<2>(7, {0.1, 0.3});
  Draws draws(2);
  for (double& x : points.position) x *= 1 + draws.uniform(-1, 1) * 4e-16;
  FiniteDifference<2> op;
  EXPECT_TRUE(is_exact<2>(op, points, 2, 1e-10));
}

/// A lattice cell of which a corner is missing: prepare() looks at the axes alone.
Points<2> cell_without_a_corner() {
  auto points = lattice<2>(3, {1, 1});
  for (Index i = 0; i < points.size(); ++i)
    if (points.at(i) == Vec<2>(2, 2)) points.position[2 * i] = 5;
  return points;
}

TEST(LatticeDifference, HasNoMixedDerivativeWithoutACornerAndSaysSo) {
  const auto points = cell_without_a_corner();
  FiniteDifference<2> op;
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  op.prepare(points, lists);
  std::vector<Mat<2>> weights(lists[0].size());
  try {
    op.hessian_weights(0, weights);
    FAIL() << "the operator accepts this cell";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.particles(), ElementsAre(0));
    EXPECT_THAT(failure.what(), HasSubstr("particle 0 lacks a corner"));
  }
}

// A failure must not leave a parallel region, which would end the program.
TEST(LatticeDifference, FailsForAMissingCornerWhenItIsApplied) {
  const auto points = cell_without_a_corner();
  FiniteDifference<2> op;
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  const std::vector<double> values(points.length.size(), 1.0);
  std::vector<double> result(4);
  op.prepare(points, lists);
  EXPECT_THROW(hessian<2>(op, lists, values, result), NumericalFailure);
}

}  // namespace
}  // namespace mote::test
