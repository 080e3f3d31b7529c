#include "mote/sums/harmonic_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mote/sums/harmonic_field.hpp"
#include "support/harmonic_cloud.hpp"

namespace mote::test {
namespace {

struct Errors {
  double potential = 0, gradient = 0;
};

/// The largest errors at eight targets, of sources of mass 1 in all, at distance 1.
Errors errors(const HarmonicCloud& cloud, const HarmonicCloud& targets, const PairRatios& ratios,
              int degree) {
  HarmonicExpansion expansion(degree, 1);
  const NodeBall from{{0, 0, 0}, ratios.source}, to{{0, 0, 1}, ratios.target};
  const auto multipole = cloud.multipole(expansion, from);
  std::vector<double> local(expansion.coefficients());
  const FarPair<3> distant{multipole.data(), {0, 0, 1}, from.radius, degree};
  expansion.translate({&distant, 1}, to.radius, local.data());
  PotentialField field(degree);
  field.prepare(local.data(), to);
  const auto values = field.at(targets.lanes());
  Errors worst;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const auto exact = cloud.sums_at(
        {targets.position[0][lane], targets.position[1][lane], targets.position[2][lane]});
    std::array<double, 4> error;
    for (std::size_t i = 0; i < 4; ++i) error[i] = static_cast<double>(values[i][lane] - exact[i]);
    worst.potential = std::max(worst.potential, std::abs(error[0]));
    worst.gradient = std::max(worst.gradient, std::hypot(error[1], error[2], error[3]));
  }
  return worst;
}

HarmonicCloud points_in(const NodeBall& ball, std::size_t count, std::uint64_t seed) {
  HarmonicCloud cloud(count, ball, Draws(seed));
  for (double& mass : cloud.strength[0]) mass = 1.0 / static_cast<double>(count);
  return cloud;
}

/// All points of a cloud at one place.
HarmonicCloud points_at(double z, std::size_t count) {
  HarmonicCloud cloud = points_in({{0, 0, 0}, 0}, count, 1);
  for (double& place : cloud.position[2]) place = z;
  return cloud;
}

class HarmonicErrors : public testing::TestWithParam<PairRatios> {};
INSTANTIATE_TEST_SUITE_P(Ratios, HarmonicErrors,
                         testing::Values(PairRatios{0.3, 0.3}, PairRatios{0.2, 0.2},
                                         PairRatios{0.45, 0.1}, PairRatios{0.1, 0.45},
                                         PairRatios{0.25, 0.4}, PairRatios{0.0, 0.3}));

constexpr int degrees[] = {0, 1, 2, 4, 7, 11};

TEST_P(HarmonicErrors, NearestPointsReachTheBoundAndNotMore) {
  const auto [a, b] = GetParam();
  const HarmonicCloud cloud = points_at(a, 1), targets = points_at(1 - b, 8);
  for (const int degree : degrees) {
    const Errors worst = errors(cloud, targets, {a, b}, degree);
    const double potential = potential_error_bound({a, b}, degree);
    const double gradient = gradient_error_bound({a, b}, degree);
    EXPECT_LE(worst.potential, potential * (1 + 1e-9)) << degree;
    EXPECT_LE(worst.gradient, gradient * (1 + 1e-9)) << degree;
    if (degree < 4) continue;
    EXPECT_GE(worst.potential, 0.8 * potential) << degree;
    EXPECT_GE(worst.gradient, 0.7 * gradient) << degree;
  }
}

TEST_P(HarmonicErrors, PointsInBallsStayBelowTheBound) {
  const auto [a, b] = GetParam();
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const std::size_t count : {1u, 4u, 50u}) {
      const HarmonicCloud cloud = points_in({{0, 0, 0}, a}, count, seed);
      const HarmonicCloud targets = points_in({{0, 0, 1}, b}, 8, seed + 100);
      for (const int degree : degrees) {
        const Errors worst = errors(cloud, targets, {a, b}, degree);
        EXPECT_LE(worst.potential, potential_error_bound({a, b}, degree) + 1e-14);
        EXPECT_LE(worst.gradient, gradient_error_bound({a, b}, degree) + 1e-13);
      }
    }
}

TEST_P(HarmonicErrors, DegreeIsTheLowestThatKeepsTheTolerance) {
  const PairRatios ratios = GetParam();
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9}) {
    const int degree = degree_for(ratios, tolerance);
    if (degree > highest_degree) {
      EXPECT_GT(potential_error_bound(ratios, highest_degree), tolerance);
      continue;
    }
    EXPECT_LE(potential_error_bound(ratios, degree), tolerance * (1 + 1e-12));
    if (degree == 0) continue;
    EXPECT_GT(potential_error_bound(ratios, degree - 1), tolerance);
  }
}

TEST(HarmonicError, ADegreeTooLowBreaksTheBound) {
  const PairRatios ratios{0.3, 0.3};
  const Errors worst = errors(points_at(0.3, 1), points_at(0.7, 8), ratios, 6);
  EXPECT_GT(worst.potential, potential_error_bound(ratios, 7));
  EXPECT_GT(worst.gradient, gradient_error_bound(ratios, 7));
}

TEST(HarmonicError, BallsThatTouchHaveNoDegree) {
  EXPECT_GT(degree_for({0.5, 0.5}, 1e-3), highest_degree);
  EXPECT_GT(degree_for({0.7, 0.6}, 1e-3), highest_degree);
}

}  // namespace
}  // namespace mote::test
