#include "mote/sums/translation_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mote/sums/harmonic_field.hpp"
#include "support/harmonic_cloud.hpp"

namespace mote::test {
namespace {

constexpr int highest = 11;

/// The potential of a cloud with a mass a point at a place, and its derivatives in z.
std::array<long double, 3> exact_at(const HarmonicCloud& cloud, std::array<double, 3> place) {
  std::array<long double, 3> sums{};
  for (std::size_t j = 0; j < cloud.size(); ++j) {
    long double square = 0;
    for (std::size_t d = 0; d < 3; ++d)
      square += std::pow(static_cast<long double>(place[d]) - cloud.position[d][j], 2.0L);
    const long double z = static_cast<long double>(place[2]) - cloud.position[2][j];
    const long double mass = cloud.strength[0][j], inverse = 1 / std::sqrt(square);
    sums[0] += mass * inverse;
    sums[1] -= mass * z * std::pow(inverse, 3);
    sums[2] += mass * (3 * z * z / square - 1) * std::pow(inverse, 3);
  }
  return sums;
}

/// What the points of a cloud hold in each degree of their expansion about a ball.
std::vector<double> powers_of(const HarmonicCloud& cloud, const HarmonicExpansion& expansion,
                              const NodeBall& ball, const std::vector<double>& multipole) {
  std::vector<double> powers(SourcePowers::count(expansion.degree()));
  const double* column = cloud.strength[0].data();
  SourcePowers(expansion, powers.data())
      .take_points({{cloud.position[0].data(), cloud.position[1].data(), cloud.position[2].data()},
                    {&column, 1},
                    cloud.size()},
                   ball, multipole.data());
  return powers;
}

/// A source about the origin, its expansion, and a target ball at distance 1 along z.
struct Pair {
  HarmonicCloud cloud;
  PairOfBalls balls;
  HarmonicExpansion expansion{highest, 1};
  std::vector<double> multipole, powers;

  Pair(HarmonicCloud points, double source, double target)
      : cloud(std::move(points)), balls{source, target, 1} {
    const NodeBall ball{{0, 0, 0}, source};
    multipole = cloud.multipole(expansion, ball);
    powers = powers_of(cloud, expansion, ball, multipole);
  }

  FarErrors bounds(int degree) const {
    const auto lanes = TranslationErrors(powers.data(), highest, balls).from_degree(degree);
    return {lanes[0][0], lanes[1][0], lanes[2][0]};
  }

  /// The largest errors at eight targets, of derivatives in z.
  FarErrors errors(const HarmonicCloud& targets, int degree) {
    std::vector<double> local(expansion.coefficients()), slope(expansion.coefficients());
    const FarPair<3> pair{multipole.data(), {0, 0, 1}, balls.source, degree};
    expansion.translate({&pair, 1}, balls.target, local.data());
    add_derivative(highest, 2, 1 / balls.target, local.data(), slope.data());
    PotentialField field(highest), slopes(highest);
    field.prepare(local.data(), {{0, 0, 1}, balls.target});
    slopes.prepare(slope.data(), {{0, 0, 1}, balls.target});
    const auto potential = field.at(targets.lanes()), derivatives = slopes.at(targets.lanes());
    FarErrors worst{};
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const auto exact = exact_at(
          cloud, {targets.position[0][lane], targets.position[1][lane], targets.position[2][lane]});
      const std::array found{potential[0][lane], potential[3][lane], derivatives[3][lane]};
      for (std::size_t i = 0; i < 3; ++i)
        worst[i] = std::max(worst[i], std::abs(static_cast<double>(found[i] - exact[i])));
    }
    return worst;
  }
};

HarmonicCloud points_in(const NodeBall& ball, std::size_t count, std::uint64_t seed) {
  return HarmonicCloud(count, ball, Draws(seed));
}

HarmonicCloud points_at(double z, std::size_t count) {
  HarmonicCloud cloud = points_in({{0, 0, z}, 0}, count, 1);
  for (double& mass : cloud.strength[0]) mass = 1;
  return cloud;
}

/// The corners of a cube with the sign of x y z: nothing below degree 3.
HarmonicCloud octupole(double side) {
  HarmonicCloud cloud = points_at(0, 8);
  for (std::size_t k = 0; k < 8; ++k) {
    double sign = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = k >> d & 1 ? 1 : -1;
      cloud.position[d][k] = side * x;
      sign *= x;
    }
    cloud.strength[0][k] = sign;
  }
  return cloud;
}

struct Radii {
  double source, target;
};
class TranslationErrorBounds : public testing::TestWithParam<Radii> {};
INSTANTIATE_TEST_SUITE_P(Radii, TranslationErrorBounds,
                         testing::Values(Radii{0.3, 0.3}, Radii{0.2, 0.2}, Radii{0.37, 0.37},
                                         Radii{0.5, 0.1}, Radii{0.1, 0.5}, Radii{0.01, 0.58}));

TEST_P(TranslationErrorBounds, HoldForPointsInBalls) {
  const auto [a, b] = GetParam();
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const std::size_t count : {1u, 4u, 50u}) {
      Pair pair(points_in({{0, 0, 0}, a}, count, seed), a, b);
      const HarmonicCloud targets = points_in({{0, 0, 1}, b}, 8, seed + 100);
      for (int degree = 2; degree <= highest; ++degree) {
        const FarErrors errors = pair.errors(targets, degree), bounds = pair.bounds(degree);
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_LE(errors[i], bounds[i] + 1e-12) << "degree " << degree << " derivative " << i;
      }
    }
}

TEST_P(TranslationErrorBounds, HoldForTheNearestPointsAndAreNotMuchLarger) {
  const auto [a, b] = GetParam();
  Pair pair(points_at(a, 1), a, b);
  const HarmonicCloud targets = points_at(1 - b, 8);
  for (int degree = 2; degree <= highest; ++degree) {
    const FarErrors errors = pair.errors(targets, degree), bounds = pair.bounds(degree);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE(errors[i], bounds[i] * (1 + 1e-9)) << "degree " << degree << " derivative " << i;
      EXPECT_GE(errors[i], 0.05 * bounds[i]) << "degree " << degree << " derivative " << i;
    }
  }
}

TEST(TranslationError, BoundsOfADegreeTooHighDoNotHold) {
  Pair pair(points_at(0.3, 1), 0.3, 0.3);
  const FarErrors errors = pair.errors(points_at(0.7, 8), 5), bounds = pair.bounds(7);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(errors[i], bounds[i]);
}

TEST(TranslationError, PointsSpreadInTheirBallNeedFewerDegreesThanOneAtItsEdge) {
  const FarErrors allowed{1e-3, 1, 1e9};
  HarmonicCloud cloud = points_in({{0, 0, 0}, 0.3}, 100, 1);
  for (double& mass : cloud.strength[0]) mass = 0.01;
  const Pair spread(cloud, 0.3, 0.3), edge(points_at(0.3, 1), 0.3, 0.3);
  const auto degree_of = [&](const Pair& pair) {
    return TranslationErrors(pair.powers.data(), highest, pair.balls).lowest_degree(allowed);
  };
  EXPECT_LE(degree_of(spread), degree_of(edge) - 2);
}

TEST(TranslationError, WhatNoDegreeHoldsIsBoundedByTheReach) {
  HarmonicExpansion low(2, 1);
  const HarmonicCloud cloud = octupole(0.2);
  const NodeBall ball{{0, 0, 0}, 0.2 * std::sqrt(3.0)};
  const auto multipole = cloud.multipole(low, ball);
  std::vector<double> powers = powers_of(cloud, low, ball, multipole);
  const std::array<double, 3> place{0.3, 0.25, 0.8};
  const double error = std::abs(static_cast<double>(exact_at(cloud, place)[0]));
  const PairOfBalls pair{ball.radius, 0.25, std::hypot(place[0], place[1], place[2])};
  EXPECT_LE(error, (TranslationErrors(powers.data(), 2, pair).from_degree(2)[0][0]));
  powers[0] = 0;  // without the strength of all points
  EXPECT_GT(error, (TranslationErrors(powers.data(), 2, pair).from_degree(2)[0][0]));
}

TEST(TranslationError, LowestDegreeIsTheLowestThatIsAllowed) {
  const Pair pair(points_in({{0, 0, 0}, 0.3}, 20, 3), 0.3, 0.3);
  const TranslationErrors errors(pair.powers.data(), highest, pair.balls);
  for (int degree = 4; degree <= highest; ++degree)
    for (std::size_t i = 0; i < 3; ++i) {
      FarErrors allowed{1e9, 1e9, 1e9};
      allowed[i] = pair.bounds(degree)[i] * (1 + 1e-9);
      EXPECT_EQ(errors.lowest_degree(allowed), degree);
    }
  EXPECT_EQ(errors.lowest_degree({1e9, 1e9, 1e9}), 3);
  EXPECT_EQ(errors.lowest_degree({0, 1e9, 1e9}), highest + 1);
}

TEST(TranslationError, PowersOfChildrenBoundThoseOfTheirPoints) {
  HarmonicCloud cloud = points_in({{0.1, 0, 0.1}, 0.1}, 30, 5);
  const NodeBall parent{{0, 0, 0}, 0.3};
  Pair whole(cloud, parent.radius, 0.3);
  const NodeBall ball{{0.1, 0, 0.1}, 0.1};
  HarmonicExpansion expansion(highest, 1);
  const auto multipole = cloud.multipole(expansion, ball);
  const auto child = powers_of(cloud, expansion, ball, multipole);
  std::vector<double> moved(child.size());
  const SourcePowers::Child of_child{child.data(), ball.radius, std::hypot(0.1, 0.1)};
  SourcePowers(expansion, moved.data())
      .take_children({&of_child, 1}, parent.radius, whole.multipole.data());
  EXPECT_NEAR(moved[0], whole.powers[0], 1e-13);
  EXPECT_GE(moved[1], whole.powers[1]);
  EXPECT_LE(moved[1], 1.4 * whole.powers[1]);
  for (std::size_t i = 2; i < moved.size(); ++i) EXPECT_EQ(moved[i], whole.powers[i]);
}

TEST(TranslationError, BallsAreTooNearBeyondTheLargestRatio) {
  EXPECT_FALSE(are_too_near({0.3, 0.3, 1}));
  EXPECT_TRUE(are_too_near({0.38, 0.38, 1}));
  EXPECT_TRUE(are_too_near({0.1, 0.6, 1}));
  EXPECT_TRUE(are_too_near({0.6, 0.1, 1}));
  EXPECT_TRUE(are_too_near({1, 1, 0.5}));
}

}  // namespace
}  // namespace mote::test
