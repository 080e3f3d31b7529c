#include "mote/operators/differential/sph.hpp"

#include <gtest/gtest.h>

#include "kernel_cases.hpp"
#include "paper_sums.hpp"
#include "support/agreement.hpp"
#include "support/altered_operator.hpp"
#include "support/clouds.hpp"
#include "support/derivatives.hpp"

namespace mote::test {
namespace {

constexpr double tolerance = 1e-12;
constexpr PairLength pair_lengths[] = {PairLength::mean, PairLength::scatter, PairLength::gather};

/// A cloud with random fields on it, and an operator that reaches a few points far.
template <class Case>
struct Sph : testing::Test {
  static constexpr int D = Case::dimension;
  using Operator = mote::Sph<D, typename Case::Kernel>;

  Points<D> points = jittered_cloud<D>({.side = D == 1 ? 60 : D == 2 ? 10 : 5});
  std::vector<double> scalar = Draws(3).uniform(points.length.size(), -1, 1);
  std::vector<double> vector = Draws(4).uniform(points.position.size(), -1, 1);

  static Operator make_operator(PairLength length) {
    Operator op;
    op.smoothing_length = 2.6 / op.kernel.support();
    op.length = length;
    return op;
  }

  WideDerivatives expected(const Operator& op) const {
    return paper_sums<D>(points, op.neighbour_rule(), scalar, vector,
                         [&](const Row<D>& row, WideDerivatives& result) {
                           add_sph_row(op.kernel, row, smoothed(op), result);
                         });
  }

  Smoothed smoothed(const Operator& op) const {
    if (op.density_from == DensityFrom::points)
      return {widened(points.mass), widened(points.density)};
    return {widened(points.mass),
            summed_density(points, op.neighbour_rule(), op.kernel, points.mass)};
  }
};
TYPED_TEST_SUITE(Sph, OperatorKernelCases, KernelCaseName);

TYPED_TEST(Sph, EqualsThePrintedSumsForEveryPairLength) {
  for (const PairLength length : pair_lengths) {
    auto op = TestFixture::make_operator(length);
    const auto expected = this->expected(op);
    const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
    EXPECT_TRUE(all_agree<TestFixture::D>(found, expected, tolerance));
  }
}

TYPED_TEST(Sph, EqualsThePrintedSumsAtEqualLengths) {
  std::ranges::fill(this->points.length, 1);
  auto op = TestFixture::make_operator(PairLength::mean);
  const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
  EXPECT_TRUE(all_agree<TestFixture::D>(found, this->expected(op), tolerance));
}

TYPED_TEST(Sph, EqualsThePrintedSumsWithTheDensitySummedUp) {
  for (const PairLength length : pair_lengths) {
    auto op = TestFixture::make_operator(length);
    op.density_from = DensityFrom::summation;
    const auto expected = this->expected(op);
    const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
    EXPECT_TRUE(all_agree<TestFixture::D>(found, expected, tolerance));
  }
}

TYPED_TEST(Sph, CheckTellsTheTwoDensitiesApart) {
  auto op = TestFixture::make_operator(PairLength::mean);
  const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
  op.density_from = DensityFrom::summation;
  EXPECT_TRUE(none_agrees<TestFixture::D>(found, this->expected(op), 1e-3));
}

TYPED_TEST(Sph, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  const auto op = TestFixture::make_operator(PairLength::mean);
  const auto expected = this->expected(op);
  AlteredOperator<D, typename TestFixture::Operator> altered(op, 7, 1e-4);
  const auto found = derivatives_of(altered, this->points, this->scalar, this->vector);
  EXPECT_TRUE(none_agrees<D>(found, expected, tolerance));
}

TYPED_TEST(Sph, ChecksTellPairLengthsApart) {
  auto op = TestFixture::make_operator(PairLength::scatter);
  const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
  op.length = PairLength::gather;
  EXPECT_TRUE(none_agrees<TestFixture::D>(found, this->expected(op), 1e-3));
}

TYPED_TEST(Sph, GivesCoincidentPointsAFiniteWeight) {
  constexpr int D = TestFixture::D;
  auto& points = this->points;
  std::copy_n(points.position.begin() + D, D, points.position.begin());
  auto op = TestFixture::make_operator(PairLength::mean);
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  op.prepare(points, lists);
  const auto twin = std::ranges::find(lists[0], 1) - lists[0].begin();
  ASSERT_LT(twin, std::ssize(lists[0]));
  std::vector<Vec<D>> gradient(lists[0].size());
  std::vector<double> laplacian(lists[0].size());
  std::vector<Mat<D>> hessian(lists[0].size());
  op.gradient_weights(0, gradient);
  op.laplacian_weights(0, laplacian);
  op.hessian_weights(0, hessian);
  EXPECT_EQ(gradient[twin].norm(), 0);
  EXPECT_TRUE(std::isfinite(laplacian[twin]));
  EXPECT_TRUE(hessian[twin].allFinite());
}

}  // namespace
}  // namespace mote::test
