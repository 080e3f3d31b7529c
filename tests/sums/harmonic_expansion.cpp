#include "mote/sums/harmonic_expansion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "mote/sums/harmonic_field.hpp"
#include "support/agreement.hpp"
#include "support/harmonic_cloud.hpp"

namespace mote::test {
namespace {

using Coefficients = std::vector<double>;

constexpr double round_off = 2e-14;
constexpr NodeBall source_ball{{0.3, 0.4, 0.5}, 0.15}, child_ball{{0.33, 0.37, 0.52}, 0.1};
constexpr NodeBall target_ball{{1.9, -0.7, -1.2}, 0.2}, grandchild_ball{{1.93, -0.65, -1.3}, 0.08};

/// S_n^m from its definition, by the library's own Legendre functions.
long double harmonic(int n, int m, const std::array<long double, 3>& x, long double r, bool sine) {
  const auto order = static_cast<unsigned>(m);
  long double ratio = m == 0 ? 1 : 2;
  for (int i = n - m + 1; i <= n + m; ++i) ratio /= i;
  const long double azimuth = m * std::atan2(x[1], x[0]);
  return std::sqrt(ratio) * std::assoc_legendre(static_cast<unsigned>(n), order, x[2] / r) *
         (sine ? std::sin(azimuth) : std::cos(azimuth));
}

/// Expansions of points by their definition: sum_j m_j (r/a)^n S of a multipole, sum_j m_j
/// b^l/r^(l+1) S of a local expansion.
std::vector<long double> by_definition(int degree, const HarmonicCloud& cloud, const NodeBall& ball,
                                       bool local) {
  std::vector<long double> result(harmonic_count(degree));
  for (std::size_t j = 0; j < cloud.size(); ++j) {
    std::array<long double, 3> x;
    for (std::size_t d = 0; d < 3; ++d)
      x[d] = static_cast<long double>(cloud.position[d][j]) - ball.centre[d];
    const long double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int n = 0; n <= degree; ++n) {
      const long double power =
          local ? std::pow(ball.radius / r, n) / r : std::pow(r / ball.radius, n);
      const long double factor = cloud.strength[0][j] * power;
      for (int m = 0; m <= n; ++m)
        result[cosine_place(n, m)] += factor * harmonic(n, m, x, r, false);
      for (int m = 1; m <= n; ++m) result[sine_place(n, m)] += factor * harmonic(n, m, x, r, true);
    }
  }
  return result;
}

HarmonicCloud cloud_of(const NodeBall& ball, std::size_t count = 21) {
  return HarmonicCloud(count, ball, Draws(5));
}

/// The local expansion of a target from one source.
Coefficients translated(HarmonicExpansion& expansion, const Coefficients& multipole,
                        const Vector3& moved, double radius, double target_radius) {
  Coefficients local(expansion.coefficients());
  const FarPair<3> source{multipole.data(), moved, radius, expansion.degree()};
  expansion.translate({&source, 1}, target_radius, local.data());
  return local;
}

/// Translation of a cloud of the radius of `source_ball` to a place that far away.
testing::AssertionResult translation_agrees(const Vector3& moved, const Vector3& claimed,
                                            double tolerance = round_off) {
  constexpr int degree = highest_degree;
  const NodeBall target{{source_ball.centre[0] + moved[0], source_ball.centre[1] + moved[1],
                         source_ball.centre[2] + moved[2]},
                        0.1};
  HarmonicExpansion expansion(degree, 1);
  const HarmonicCloud cloud = cloud_of(source_ball);
  return agree(translated(expansion, cloud.multipole(expansion, source_ball), claimed,
                          source_ball.radius, target.radius),
               by_definition(degree, cloud, target, true), tolerance);
}

/// A local expansion at eight points.
std::vector<double> potentials(int degree, const double* local, const NodeBall& ball,
                               const HarmonicCloud& points) {
  PotentialField field(degree);
  field.prepare(local, ball);
  const Lanes values = field.at(points.lanes())[0];
  std::vector<double> result(lane_count);
  values.copy_to(result.data(), std::experimental::element_aligned);
  return result;
}

class HarmonicExpansions : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Degrees, HarmonicExpansions,
                         testing::Values(0, 1, 2, 3, 5, 10, 16, 17, 23, 40));

TEST_P(HarmonicExpansions, PointsGiveTheMultipoleOfItsDefinition) {
  HarmonicExpansion expansion(GetParam(), 1);
  for (const std::size_t count : {1u, 8u, 21u}) {
    const HarmonicCloud cloud = cloud_of(source_ball, count);
    EXPECT_TRUE(agree(cloud.multipole(expansion, source_ball),
                      by_definition(GetParam(), cloud, source_ball, false), round_off));
  }
}

TEST_P(HarmonicExpansions, ChildrenGiveTheMultipoleOfTheirPoints) {
  HarmonicExpansion expansion(GetParam(), 1);
  std::vector<Coefficients> multipoles;
  std::vector<ChildMultipole> children;
  std::vector<long double> expected(expansion.coefficients());
  multipoles.reserve(11);  // more than fit into the lanes
  for (int i = 0; i < 11; ++i) {
    const NodeBall ball{{0.25 + 0.02 * i, 0.4 - 0.01 * i, 0.5 + 0.003 * i * i}, 0.02};
    const HarmonicCloud cloud(9, ball, Draws(static_cast<std::uint64_t>(i)));
    multipoles.push_back(cloud.multipole(expansion, ball));
    children.push_back({multipoles.back().data(), ball});
    const auto own = by_definition(GetParam(), cloud, {source_ball.centre, 0.5}, false);
    for (std::size_t k = 0; k < own.size(); ++k) expected[k] += own[k];
  }
  Coefficients parent(expansion.coefficients());
  expansion.shift_up(children, {source_ball.centre, 0.5}, parent.data());
  EXPECT_TRUE(agree(parent, expected, round_off));
}

TEST_P(HarmonicExpansions, ChildrenTakeOverTheFunctionOfTheirParent) {
  HarmonicExpansion expansion(GetParam(), 1);
  const Coefficients parent = Draws(3).uniform(expansion.coefficients(), -1, 1);
  const std::vector<NodeBall> balls(11, grandchild_ball);  // more than fit into the lanes
  std::vector<Coefficients> children(balls.size(), Coefficients(expansion.coefficients()));
  std::vector<ChildLocal> shifts;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    shifts.push_back({children[i].data(), balls[i]});
    shifts.back().ball.centre[0] -= 0.01 * static_cast<double>(i);
  }
  expansion.shift_down(parent.data(), target_ball, shifts);
  const HarmonicCloud points(8, {{1.88, -0.65, -1.3}, 0.02}, Draws(2));  // in the balls of all
  const auto expected = potentials(GetParam(), parent.data(), target_ball, points);
  for (const ChildLocal& child : shifts)
    EXPECT_TRUE(agree(potentials(GetParam(), child.local, child.ball, points), expected, 1e-13));
}

TEST(HarmonicExpansionAtHighDegree, DistantPointsGiveTheLocalExpansionOfItsDefinition) {
  const Vector3 moved = displacement(source_ball, target_ball);
  EXPECT_TRUE(translation_agrees(moved, moved));
}

TEST(HarmonicExpansionAtHighDegree, DisplacementsAlongAxes) {
  for (std::size_t d = 0; d < 3; ++d)
    for (const double sign : {-1.0, 1.0}) {
      Vector3 moved{};
      moved[d] = 1.7 * sign;
      EXPECT_TRUE(translation_agrees(moved, moved)) << d << ' ' << sign;
      moved[(d + 1) % 3] = 1e-160;  // its square is no number
      EXPECT_TRUE(translation_agrees(moved, moved)) << d << ' ' << sign;
      moved[(d + 1) % 3] = 1e-9;
      EXPECT_TRUE(translation_agrees(moved, moved)) << d << ' ' << sign;
    }
}

TEST(HarmonicExpansionAtHighDegree, ChecksNoticeAWrongDisplacement) {
  const Vector3 moved{0.7, 0.9, -1.1};
  EXPECT_TRUE(translation_agrees(moved, moved));
  EXPECT_FALSE(translation_agrees(moved, {0.9, 0.7, -1.1}));
  EXPECT_FALSE(translation_agrees(moved, {-0.7, -0.9, 1.1}));
  EXPECT_FALSE(translation_agrees(moved, {0.7 * (1 + 1e-11), 0.9, -1.1}));
}

TEST(HarmonicExpansionAtHighDegree, GrandchildrenGetTheLocalExpansionOfDistantPoints) {
  HarmonicExpansion expansion(highest_degree, 1);
  const HarmonicCloud cloud = cloud_of(source_ball);
  const Coefficients local =
      translated(expansion, cloud.multipole(expansion, source_ball),
                 displacement(source_ball, target_ball), source_ball.radius, target_ball.radius);
  Coefficients child(expansion.coefficients());
  const ChildLocal down{child.data(), grandchild_ball};
  expansion.shift_down(local.data(), target_ball, {&down, 1});
  EXPECT_TRUE(agree(child, by_definition(highest_degree, cloud, grandchild_ball, true), round_off));
}

/// Twenty sources of several degrees around a target, of three components.
struct ManySources : testing::Test {
  static constexpr int degree = 12;
  HarmonicExpansion expansion{degree, 3}, single{degree, 1};
  std::vector<Coefficients> multipoles;
  std::vector<FarPair<3>> sources;

  ManySources() {
    Draws draws(8);
    for (int i = 0; i < 20; ++i) {
      multipoles.push_back(draws.uniform(expansion.coefficients(), -1, 1));
      const double angle = 0.3 * i;
      sources.push_back({multipoles.back().data(),
                         {2 * std::cos(angle), 2 * std::sin(angle), draws.uniform(-1, 1)},
                         draws.uniform(0.1, 0.9),
                         i % 5 == 0 ? 12 : 4 + i % 3});
    }
  }

  Coefficients local(HarmonicExpansion& by, double scale = 1, std::size_t component = 0) {
    Coefficients result(by.coefficients());
    auto scaled = sources;
    for (FarPair<3>& source : scaled) {
      source.series += component * harmonic_count(degree);
      for (double& d : source.distance) d *= scale;
      source.radius *= scale;
    }
    by.translate(scaled, 0.4 * scale, result.data());
    return result;
  }
};

TEST_F(ManySources, ComponentsAreWhatEachOfThemIsAlone) {
  const Coefficients together = local(expansion);
  for (std::size_t c = 0; c < 3; ++c) {
    const Coefficients alone = local(single, 1, c);
    for (std::size_t i = 0; i < alone.size(); ++i)
      ASSERT_EQ(together[c * alone.size() + i], alone[i]) << c << ' ' << i;
  }
}

TEST_F(ManySources, SameBitsIfCalledAgain) { EXPECT_EQ(local(expansion), local(expansion)); }

TEST_F(ManySources, EightOfLikeDegreesAreTakenWithTheirHighest) {
  const Coefficients together = local(single);
  Coefficients one_by_one(single.coefficients());
  std::ranges::stable_sort(sources, std::greater(), &FarPair<3>::degree);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    FarPair<3> source = sources[i];
    source.degree = sources[i - i % lane_count].degree;
    single.translate({&source, 1}, 0.4, one_by_one.data());
  }
  EXPECT_TRUE(agree(together, one_by_one, round_off));
}

TEST_F(ManySources, LowDegreesTakeAndGiveTheBeginningOfAnExpansion) {
  for (FarPair<3>& source : sources) source.degree = 1;
  const Coefficients first = local(single);
  EXPECT_NE(first[harmonic_count(1) - 1], 0);
  for (std::size_t i = harmonic_count(1); i < first.size(); ++i) ASSERT_EQ(first[i], 0) << i;
}

TEST_F(ManySources, NumbersDoNotDependOnTheUnitOfLength) {
  const Coefficients unit = local(single);
  for (const double scale : {0x1p-498, 0x1p-332, 0x1p332, 0x1p498}) {  // about 1e-150 to 1e150
    Coefficients scaled = local(single, scale);
    for (double& value : scaled) value *= scale;
    EXPECT_EQ(scaled, unit) << scale;
  }
}

TEST(HarmonicExpansionOfLowDegree, MassesAndDipolesAreTheirFormulas) {
  const Coefficients multipole{2, 0.3, -0.5, 0.7};  // the dipole in the order z, x, y
  const Vector3 moved{1, 2, -2}, direction{1.0 / 3, 2.0 / 3, -2.0 / 3};
  constexpr double distance = 3, a = 0.4, b = 0.5;
  const Vector3 dipole{-0.5, 0.7, 0.3};
  const double along =
      dipole[0] * direction[0] + dipole[1] * direction[1] + dipole[2] * direction[2];
  HarmonicExpansion zeroth(0, 1), first(1, 1);
  EXPECT_TRUE(
      agree(translated(zeroth, {2}, moved, a, b), std::vector<double>{2 / distance}, 1e-15));
  std::vector<double> expected{2 / distance + a / 9 * along, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t d = (i + 2) % 3;
    expected[1 + i] =
        -b / 9 * 2 * direction[d] + a * b / 27 * (dipole[d] - 3 * along * direction[d]);
  }
  EXPECT_TRUE(agree(translated(first, multipole, moved, a, b), expected, 1e-15));
}

TEST(HarmonicExpansionOfOnePlace, NodesWithoutExtentKeepTheirMass) {
  HarmonicExpansion expansion(7, 1);
  const NodeBall place{source_ball.centre, 0};
  HarmonicCloud cloud = cloud_of(place, 3);
  const Coefficients multipole = cloud.multipole(expansion, place);
  const double mass = cloud.strength[0][0] + cloud.strength[0][1] + cloud.strength[0][2];
  EXPECT_DOUBLE_EQ(multipole[0], mass);
  Coefficients parent(expansion.coefficients()), wider(expansion.coefficients());
  const ChildMultipole child{multipole.data(), place};
  expansion.shift_up({&child, 1}, place, parent.data());
  EXPECT_EQ(parent, multipole);
  expansion.shift_up({&child, 1}, source_ball, wider.data());
  EXPECT_EQ(wider, multipole);
  const Vector3 moved = displacement(place, target_ball);
  EXPECT_TRUE(agree(translated(expansion, multipole, moved, 0, target_ball.radius),
                    by_definition(7, cloud, target_ball, true), round_off));
}

}  // namespace
}  // namespace mote::test
