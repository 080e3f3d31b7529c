#include "mote/operators/differential/mps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
        [&](const Row<D>& row, WideDerivatives& result) { add_mps_row(points, row, result); });
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
    EXPECT_TRUE(agree(found.gradient, expected.gradient, tolerance));
    EXPECT_TRUE(agree(found.divergence, expected.divergence, tolerance));
    EXPECT_TRUE(agree(found.laplacian, expected.laplacian, tolerance));
  }
}

TYPED_TEST(Mps, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  const auto op = TestFixture::make_operator(PairLength::mean);
  const auto expected = this->expected(op);
  AlteredOperator<D, mote::Mps<D>> altered(op, 7, 1e-4);
  const auto found = derivatives_of(altered, this->points, this->scalar, this->vector);
  EXPECT_FALSE(agree(found.gradient, expected.gradient, tolerance));
  EXPECT_FALSE(agree(found.divergence, expected.divergence, tolerance));
  EXPECT_FALSE(agree(found.laplacian, expected.laplacian, tolerance));
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

}  // namespace
}  // namespace mote::test
