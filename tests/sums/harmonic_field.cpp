#include "mote/sums/harmonic_field.hpp"

#include <gtest/gtest.h>

#include "support/agreement.hpp"
#include "support/harmonic_cloud.hpp"

namespace mote::test {
namespace {

constexpr NodeBall source{{0.2, -0.1, 0.4}, 0.2}, target{{1.1, 1.3, -0.8}, 0.3};

/// What a target of eight points gets from a cloud, by expansions and by sums over all pairs; both
/// are 16 numbers a point, as HarmonicCloud::sums_at has them.
struct Field {
  NodeBall from = source, to = target;
  HarmonicCloud cloud{30, from, Draws(9)}, points{8, to, Draws(10)};

  explicit Field(double unit = 1) {
    for (std::size_t d = 0; d < 3; ++d) {
      from.centre[d] *= unit;
      to.centre[d] *= unit;
    }
    from.radius *= unit;
    to.radius *= unit;
    cloud = HarmonicCloud(30, from, Draws(9));
    points = HarmonicCloud(8, to, Draws(10));
  }

  std::vector<double> local(int degree) const {
    HarmonicExpansion expansion(degree, 3);
    const auto multipole = cloud.multipole(expansion, from);
    std::vector<double> result(expansion.coefficients());
    const FarPair<3> distant{multipole.data(), displacement(from, to), from.radius, degree};
    expansion.translate({&distant, 1}, to.radius, result.data());
    return result;
  }

  /// Numbers `first` to `last` of all points.
  std::vector<double> by_expansion(int degree, std::size_t first, std::size_t last) const {
    const auto coefficients = local(degree);
    PotentialField potential(degree);
    CurlField curl(degree);
    potential.prepare(coefficients.data(), to);
    curl.prepare(coefficients.data(), to, true);
    const auto scalar = potential.at(points.lanes());
    const auto vector = curl.with_gradient(points.lanes());
    std::vector<double> result;
    for (std::size_t i = first; i <= last; ++i)
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        result.push_back(i < 4 ? scalar[i][lane] : vector[i - 4][lane]);
    return result;
  }

  std::vector<long double> by_pairs(std::size_t first, std::size_t last) const {
    std::vector<long double> result;
    for (std::size_t i = first; i <= last; ++i)
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        result.push_back(cloud.sums_at(
            {points.position[0][lane], points.position[1][lane], points.position[2][lane]})[i]);
    return result;
  }

  testing::AssertionResult agrees(int degree, std::size_t first, std::size_t last,
                                  double tolerance) const {
    return agree(by_expansion(degree, first, last), by_pairs(first, last), tolerance);
  }
};

TEST(HarmonicField, PotentialGradientCurlAndItsGradientAreTheSumsOverPairs) {
  for (const double unit : {1.0, 1e-90, 1e90}) {
    const Field field(unit);
    EXPECT_TRUE(field.agrees(highest_degree, 0, 0, 2e-14)) << unit;
    EXPECT_TRUE(field.agrees(highest_degree, 1, 3, 2e-14)) << unit;
    EXPECT_TRUE(field.agrees(highest_degree, 4, 6, 2e-14)) << unit;
    EXPECT_TRUE(field.agrees(highest_degree, 7, 15, 2e-14)) << unit;
  }
}

TEST(HarmonicField, CurlAloneIsTheSame) {
  const Field field;
  const auto local = field.local(9);
  CurlField alone(9), both(9);
  alone.prepare(local.data(), field.to, false);
  both.prepare(local.data(), field.to, true);
  const auto velocity = alone.at(field.points.lanes());
  const auto with_gradient = both.with_gradient(field.points.lanes());
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      EXPECT_EQ(velocity[d][lane], with_gradient[d][lane]);
}

TEST(HarmonicField, LowDegreesAreTheirPolynomials) {
  const std::vector<double> local{2, 3, 5, 7, 0, 0, 0, 0, 11};  // the last is r^2 S_2^2, sine
  const NodeBall ball{{1, 1, 1}, 2};
  const std::array<Lanes, 3> point{Lanes(1.5), Lanes(2), Lanes(1.25)};  // x, y, z = 1/4, 1/2, 1/8
  const double root = std::sqrt(3.0);                                   // r^2 S_2^2 is root x y
  const std::vector<std::vector<double>> expected{
      {2, 0, 0, 0},
      {2 + 3 * 0.125 + 5 * 0.25 + 7 * 0.5, 2.5, 3.5, 1.5},
      {2 + 3 * 0.125 + 5 * 0.25 + 7 * 0.5 + 11 * root * 0.125, 2.5 + 11 * root * 0.25,
       3.5 + 11 * root * 0.125, 1.5}};
  for (int degree = 0; degree <= 2; ++degree) {
    PotentialField field(degree);
    field.prepare(local.data(), ball);
    const auto values = field.at(point);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(values[i][3], expected[static_cast<std::size_t>(degree)][i], 1e-14) << degree;
  }
}

TEST(HarmonicField, ChecksNoticeAnAlteredCoefficient) {
  const Field field;
  auto local = field.local(highest_degree);
  PotentialField potential(highest_degree);
  const auto agrees = [&] {
    potential.prepare(local.data(), field.to);
    const auto values = potential.at(field.points.lanes());
    std::vector<double> gradient;
    for (std::size_t i = 1; i < 4; ++i)
      for (std::size_t lane = 0; lane < lane_count; ++lane) gradient.push_back(values[i][lane]);
    return agree(gradient, field.by_pairs(1, 3), 2e-14);
  };
  EXPECT_TRUE(agrees());
  std::swap(local[cosine_place(3, 2)], local[sine_place(3, 2)]);
  EXPECT_FALSE(agrees());
}

}  // namespace
}  // namespace mote::test
