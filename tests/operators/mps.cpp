#include "mote/operators/differential/mps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <span>

#include "paper_sums.hpp"
#include "support/agreement.hpp"
#include "support/altered_operator.hpp"
#include "support/clouds.hpp"
#include "support/derivatives.hpp"

namespace mote::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double tolerance = 1e-12;

template <class Dimension>
struct Mps : testing::Test {
  static constexpr int D = Dimension::value;

  Points<D> points = jittered_cloud<D>({.side = D == 1 ? 60 : D == 2 ? 12 : 6});
  std::vector<double> scalar = Draws(3).uniform(points.length.size(), -1, 1);
  std::vector<double> vector = Draws(4).uniform(points.position.size(), -1, 1);

  static mote::Mps<D> make_operator(PairLength length) {
    mote::Mps<D> op;
    op.smoothing_length = 2.6;
    op.length = length;
    return op;
  }

  WideDerivatives expected(const mote::Mps<D>& op) const {
    return paper_sums<D>(
        points, op.neighbour_rule(), scalar, vector,
        [&](const Row<D>& row, WideDerivatives& result) { add_mps_row(row, result); });
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Mps, Dimensions);

TYPED_TEST(Mps, EqualsThePrintedSumsForEveryPairLength) {
  for (const PairLength length : {PairLength::mean, PairLength::scatter, PairLength::gather}) {
    auto op = TestFixture::make_operator(length);
    const auto expected = this->expected(op);
    const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
    EXPECT_TRUE(all_agree<TestFixture::D>(found, expected, tolerance));
  }
}

TYPED_TEST(Mps, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  const auto op = TestFixture::make_operator(PairLength::mean);
  const auto expected = this->expected(op);
  AlteredOperator<D, mote::Mps<D>> altered(op, 7, 1e-4);
  const auto found = derivatives_of(altered, this->points, this->scalar, this->vector);
  EXPECT_TRUE(none_agrees<D>(found, expected, tolerance));
}

/// The failure that preparing MPS on these points gives; none fails the test.
template <int D>
NumericalFailure failure_of(const Points<D>& points, mote::Mps<D> op = {}) {
  try {
    op.prepare(points, brute_force(points, op.neighbour_rule()));
  } catch (const NumericalFailure& failure) {
    return failure;
  }
  ADD_FAILURE() << "the operator accepts these points";
  return {"", {}, ""};
}

TYPED_TEST(Mps, RefusesCoincidentParticlesByName) {
  constexpr int D = TestFixture::D;
  auto points = jittered_cloud<D>({.side = 4, .jitter = 0.05, .variation = 0});
  std::copy_n(points.position.begin(), D, points.position.begin() + 2 * D);
  const NumericalFailure failure = failure_of<D>(points);
  EXPECT_THAT(failure.particles(), Contains(0));
  EXPECT_THAT(failure.what(), HasSubstr("particle 0 coincides"));
  EXPECT_THAT(failure.cause(), HasSubstr("r = 0"));
}

TYPED_TEST(Mps, RefusesAnIsolatedParticleByName) {
  constexpr int D = TestFixture::D;
  auto points = jittered_cloud<D>({.side = 4, .jitter = 0.05, .variation = 0});
  points.position[2 * D] = 1000;
  const NumericalFailure failure = failure_of<D>(points);
  EXPECT_THAT(failure.particles(), testing::ElementsAre(2));
  EXPECT_THAT(failure.what(), HasSubstr("particle 2 has no neighbour"));
}

// A neighbour exactly on the rim has the weight 0: it is no neighbour.
TEST(MpsOnALine, RefusesAParticleWhoseNeighboursAreAllOnTheRim) {
  mote::Mps<1> op;
  op.smoothing_length = 1;
  EXPECT_THAT(failure_of<1>(line_points({0, 1, 2, 3}), op).what(), HasSubstr("has no neighbour"));
}

TEST(MpsOnALine, AcceptsCoincidentPointsOutOfReachOfEveryReceiver) {
  auto points = line_points({0, 1, 2, 50, 50});
  points.receivers = 3;
  mote::Mps<1> op;
  EXPECT_NO_THROW(op.prepare(points, brute_force(points, op.neighbour_rule())));
}

TEST(MpsOnALine, IsExactForParabolasOnARegularLine) {
  auto points = line_points({0, 1, 2, 3, 4, 5, 6});
  std::swap(points.position[0], points.position[3]);
  points.receivers = 1;
  std::vector<double> scalar;
  for (const double x : points.position) scalar.push_back(2 + 3 * x - 5 * x * x);
  mote::Mps<1> op;
  op.smoothing_length = 2.5;
  const auto found = derivatives_of<1>(op, points, scalar, scalar);
  EXPECT_NEAR(found.gradient[0], 3 - 10 * points.position[0], 1e-13);
  EXPECT_NEAR(found.laplacian[0], -10, 1e-13);
}

/// A receiver in the middle of these places.
template <int D>
Points<D> star(const std::vector<Vec<D>>& places) {
  Points<D> points;
  points.resize(static_cast<Index>(places.size()) + 1, 1);
  std::ranges::fill(points.length, 1);
  for (std::size_t k = 0; k < places.size(); ++k)
    Vec<D>::Map(&points.position[(k + 1) * D]) = places[k];
  return points;
}

Points<2> hexagon() {
  std::vector<Vec<2>> places;
  for (int k = 0; k < 6; ++k)
    places.emplace_back(std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3));
  return star<2>(places);
}

Points<3> icosahedron() {
  std::vector<Vec<3>> places;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-std::numbers::phi, std::numbers::phi})
      places.insert(places.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
  for (Vec<3>& place : places) place.normalize();
  return star<3>(places);
}

Points<2> square() { return star<2>({{1, 0}, {-1, 0}, {0, 1}, {0, -1}}); }

/// The Hessian of x^T A x/2, where A is symmetric, in the middle of these points.
template <int D>
std::vector<double> hessian_of_parabola(const Points<D>& points, const Mat<D>& a) {
  std::vector<double> values, result(D * D);
  for (Index i = 0; i < points.size(); ++i)
    values.push_back(points.at(i).dot(a * points.at(i)) / 2);
  mote::Mps<D> op;
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  op.prepare(points, lists);
  hessian<D>(op, lists, values, result);
  return result;
}

template <int D>
testing::AssertionResult has_hessian_of(const Points<D>& points, const Mat<D>& a) {
  return agree(hessian_of_parabola<D>(points, a), std::span(a.data(), D * D), 1e-14);
}

// Exact where the second and fourth moments of the neighbourhood are isotropic, as in a hexagon and
// an icosahedron. Those of a square are not: there only its trace is exact, and the parabola |x|^2.
TEST(MpsHessian, IsExactForParabolasWhereTheFourthMomentsAreIsotropic) {
  EXPECT_TRUE(has_hessian_of<2>(hexagon(), Mat<2>{{2, -3}, {-3, 5}}));
  EXPECT_TRUE(has_hessian_of<3>(icosahedron(), Mat<3>{{2, -3, 1}, {-3, 5, 7}, {1, 7, -4}}));
}

TEST(MpsHessian, IsExactForTheIsotropicParabolaOnASquareAndForNoOther) {
  EXPECT_TRUE(has_hessian_of<2>(square(), Mat<2>::Identity()));
  EXPECT_FALSE(has_hessian_of<2>(square(), Mat<2>{{1, 0}, {0, -1}}));
  EXPECT_FALSE(has_hessian_of<2>(square(), Mat<2>{{0, 1}, {1, 0}}));
}

TEST(MpsHessian, HasAnExactTraceOnASquare) {
  const auto found = hessian_of_parabola<2>(square(), Mat<2>{{2, -3}, {-3, 5}});
  EXPECT_NEAR(found[0] + found[3], 7, 1e-14);
}

}  // namespace
}  // namespace mote::test
