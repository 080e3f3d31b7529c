#include "mote/study/check_up.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "support/brute_force.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The points of an integer lattice of this spacing that `chosen` takes, within `reach` spacings of
/// the origin in each coordinate. The origin comes first and is the only receiver.
template <int D, class Chosen>
Points<D> lattice_around(Index reach, double spacing, Chosen chosen) {
  std::vector<Vec<D>> places{Vec<D>::Zero()};
  const Index side = 2 * reach + 1;
  const auto cells = static_cast<Index>(std::lround(std::pow(side, D)));
  for (Index k = 0; k < cells; ++k) {
    Vec<D> x;
    for (Index d = 0, rest = k; d < D; ++d, rest /= side) x[d] = rest % side - reach;
    if (x.norm() > 0 && chosen(x)) places.push_back(x);
  }
  Points<D> points;
  points.resize(static_cast<Index>(places.size()), 1);
  for (std::size_t i = 0; i < places.size(); ++i)
    Vec<D>::Map(&points.position[i * D]) = spacing * places[i];
  points.length.assign(places.size(), spacing);
  return points;
}

/// The neighbourhood of the first point.
template <int D>
Neighbourhood first_of(const Points<D>& points, double reach) {
  const NeighbourRule rule{.support = 2, .smoothing_length = reach / 2};
  return check_up(points, rule, brute_force(points, rule)).front();
}

constexpr auto all = [](const auto&) { return true; };

template <class Dimension>
struct CheckUpIn : testing::Test {
  static constexpr int D = Dimension::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(CheckUpIn, Dimensions);

/// The 3^D - 1 next points of a lattice. Columns of different parity are orthogonal; those of two
/// squares, of length 1, have the product c = 2/3, so D of them have the singular values
/// sqrt(1 + (D-1) c) and sqrt(1 - c).
TYPED_TEST(CheckUpIn, KnowsTheConditionOfALattice) {
  constexpr int D = TestFixture::D;
  const double expected = D == 1 ? 1 : (D == 2 ? std::sqrt(5) : std::sqrt(7));
  for (const double spacing : {1.0, 1e-3, 250.0}) {
    const Neighbourhood found = first_of(lattice_around<D>(2, spacing, all), 1.8);
    EXPECT_EQ(found.neighbours, std::pow(3, D) - 1);
    EXPECT_NEAR(found.condition, expected, 1e-12);
  }
}

TYPED_TEST(CheckUpIn, IsNoWorseThanAFewUnitsOnWiderLattices) {
  constexpr int D = TestFixture::D;
  for (const double reach : {2.0, 3.0, 4.5})
    EXPECT_LT(first_of(lattice_around<D>(5, 1, all), reach).condition, 6) << reach;
}

/// The cells whose midpoints lie in a ball of radius R fill one of radius R - a and lie in one of
/// radius R + a, a = sqrt(D)/2 being half a cell's diagonal.
TYPED_TEST(CheckUpIn, IsCoveredInside) {
  constexpr int D = TestFixture::D;
  for (const double R : {4.0, 8.3}) {
    const double a = std::sqrt(D) / 2,
                 covered = first_of(lattice_around<D>(9, 0.1, all), R).covered;
    EXPECT_GT(covered, std::pow(1 - a / R, D));
    EXPECT_LT(covered, std::pow(1 + a / R, D));
  }
}

/// Half of that at a free side, and at most the point's own layer of cells more.
TYPED_TEST(CheckUpIn, IsHalfCoveredAtAFreeSide) {
  constexpr int D = TestFixture::D;
  const auto half = [](const Vec<D>& x) { return x[0] >= 0; };
  const double ball = D == 1 ? 2 : (D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3);
  const double section = D == 1 ? 1 : (D == 2 ? 2 : std::numbers::pi);
  for (const double R : {4.0, 8.3}) {
    const double a = std::sqrt(D) / 2, layer = 0.5 * section / (ball * R);
    const double covered = first_of(lattice_around<D>(9, 0.1, half), R).covered;
    EXPECT_GT(covered, 0.5 * std::pow(1 - a / R, D));
    EXPECT_LT(covered, (0.5 + layer) * std::pow(1 + a / R, D));
    EXPECT_LT(covered, 0.7 * first_of(lattice_around<D>(9, 0.1, all), R).covered);
  }
}

TYPED_TEST(CheckUpIn, CountsVolumesOfDifferentPoints) {
  constexpr int D = TestFixture::D;
  auto points = lattice_around<D>(1, 1, all);
  points.length[1] = 0.5;
  const NeighbourRule rule{.support = 1.8, .length = PairLength::gather};
  const double ball = D == 1 ? 2 : (D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3);
  EXPECT_NEAR(check_up(points, rule, brute_force(points, rule))[0].covered,
              (std::pow(3, D) - 1 + std::pow(0.5, D)) / (ball * std::pow(1.8, D)), 1e-14);
}

/// Too few points, or one side only of a line, or a line or plane where there should be more.
TYPED_TEST(CheckUpIn, KnowsThatNoParabolaIsFixed) {
  constexpr int D = TestFixture::D;
  const auto few = [](const Vec<D>& x) { return x[0] == 1 && x.norm() < 1.1; };
  EXPECT_EQ(first_of(lattice_around<D>(2, 1, few), 3).condition, infinity);
  EXPECT_EQ(first_of(lattice_around<D>(2, 1, [](const Vec<D>&) { return false; }), 3).condition,
            infinity);
  if constexpr (D > 1) {
    const auto on_axis = [](const Vec<D>& x) { return x[D - 1] == 0; };
    const auto on_diagonal = [](const Vec<D>& x) { return x[0] == x[1]; };
    EXPECT_EQ(first_of(lattice_around<D>(8, 1, on_axis), 8).condition, infinity);
    EXPECT_EQ(first_of(lattice_around<D>(8, 0.37, on_diagonal), 8).condition, infinity);
  }
}

/// On a line at any angle, up to rounding of the places.
TEST(CheckUp, KnowsPointsOnALineInThePlane) {
  Draws draws(4);
  for (const double angle : {0.1, 0.7, 1.2, 2.9}) {
    Points<2> points;
    points.resize(31, 1);
    for (Index i = 1; i < 31; ++i) {
      const double s = draws.uniform(-2, 2);
      points.position[2 * i] = s * std::cos(angle);
      points.position[2 * i + 1] = s * std::sin(angle);
    }
    points.length.assign(31, 1);
    EXPECT_GT(first_of(points, 3).condition, 1e13) << angle;
    points.position[3] += 0.1;  // one point beside the line does not fix a parabola, three do
    EXPECT_GT(first_of(points, 3).condition, 1e13) << angle;
    for (Index i = 2; i < 6; ++i) points.position[2 * i + 1] += 0.1 * i * i;
    EXPECT_LT(first_of(points, 3).condition, 1e5) << angle;
  }
}

TEST(CheckUp, SummaryPicksTheWorstPoints) {
  const CheckUpSummary summary = summary_of(
      {{7, 0.9, 3}, {4, 0.5, infinity}, {9, 0.4, 5}, {4, 0.4, 8}, {5, 0.7, infinity}, {6, 0.6, 8}});
  EXPECT_EQ(summary.fewest.value, 4);
  EXPECT_EQ(summary.fewest.point, 1);
  EXPECT_EQ(summary.least_covered.value, 0.4);
  EXPECT_EQ(summary.least_covered.point, 2);
  EXPECT_EQ(summary.worst_condition.value, 8);
  EXPECT_EQ(summary.worst_condition.point, 3);
  EXPECT_EQ(summary.without_parabola, 2);
}

TEST(CheckUp, SummaryOfGoodPointsHasNoneWithoutParabola) {
  EXPECT_EQ(summary_of({{7, 0.9, 3}}).without_parabola, 0);
}

}  // namespace
}  // namespace mote::test
