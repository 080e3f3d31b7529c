// The corrected mps, for what its moment matrices make exact on disorder.

#include "mote/operators/differential/corrected_mps.hpp"

#include <gtest/gtest.h>

#include "mote/operators/differential/mps.hpp"
#include "support/agreement.hpp"
#include "support/altered_operator.hpp"
#include "support/dimensions.hpp"
#include "support/polynomial.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

constexpr double tolerance = 1e-9;

/// How the derivatives that an operator finds agree with those of polynomials of some degree.
struct Agreement {
  bool gradient, laplacian, hessian;
};

template <int D>
Agreement agreement(DifferentialOperator<D>& op, int degree, double within = tolerance) {
  const Points<D> points = jittered_cloud<D>({.side = usual_side<D>});
  const Derivatives found = derivatives_of_polynomials(op, points, degree),
                    exact = PolynomialFields<D>(degree).derivatives(points);
  return {agree(found.gradient, exact.gradient, within),
          agree(found.laplacian, exact.laplacian, within),
          agree(found.hessian, exact.hessian, within)};
}

template <class Dimension>
struct CorrectedMps : testing::Test {
  static constexpr int D = Dimension::value;

  static mote::CorrectedMps<D> make_operator() {
    mote::CorrectedMps<D> op;
    op.smoothing_length = 3.6;
    return op;
  }
};
TYPED_TEST_SUITE(CorrectedMps, Dimensions, NameOfDimension);

TYPED_TEST(CorrectedMps, IsExactForLinearFieldsAndForSecondDerivativesOfParabolas) {
  auto op = TestFixture::make_operator();
  EXPECT_TRUE(agreement<TestFixture::D>(op, 1).gradient);
  EXPECT_TRUE(agreement<TestFixture::D>(op, 2).laplacian);
  EXPECT_TRUE(agreement<TestFixture::D>(op, 2).hessian);
}

TYPED_TEST(CorrectedMps, IsNotExactForOneDegreeMore) {
  auto op = TestFixture::make_operator();
  EXPECT_FALSE(agreement<TestFixture::D>(op, 2, 1e-4).gradient);
  EXPECT_FALSE(agreement<TestFixture::D>(op, 3, 1e-4).laplacian);
}

/// Negative controls: mps without the correction, and one weight that is wrong.
TYPED_TEST(CorrectedMps, CheckNoticesWhatIsNotCorrected) {
  constexpr int D = TestFixture::D;
  Mps<D> plain;
  EXPECT_TRUE(D == 1 || !agreement<D>(plain, 1, 1e-3).gradient);
  EXPECT_FALSE(agreement<D>(plain, 2, 1e-3).laplacian);
  AlteredOperator<D, mote::CorrectedMps<D>> altered(TestFixture::make_operator(), 7, 1e-5);
  EXPECT_FALSE(agreement<D>(altered, 1).gradient);
  EXPECT_FALSE(agreement<D>(altered, 2).laplacian);
}

/// On a lattice the corrected gradient is that of mps.
TYPED_TEST(CorrectedMps, HasTheGradientOfMpsWhereNeighboursLieEvenly) {
  constexpr int D = TestFixture::D;
  auto points = jittered_cloud<D>({.side = 5, .jitter = 0, .variation = 0});
  Index middle = 0;
  while (points.at(middle) != Vec<D>::Constant(2)) ++middle;
  points.receivers = middle + 1;
  auto corrected = TestFixture::make_operator();
  Mps<D> plain;
  corrected.smoothing_length = plain.smoothing_length = 1.9;
  const NeighbourLists lists = brute_force(points, plain.neighbour_rule());
  const auto weights_of = [&](DifferentialOperator<D>& op) {
    Eigen::Matrix<double, Eigen::Dynamic, D> rows(lists[middle].size(), D);
    std::vector<Vec<D>> weights(lists[middle].size());
    points.exempt.assign(static_cast<std::size_t>(points.receivers), true);
    op.prepare(points, lists);
    op.gradient_weights(middle, weights);
    for (std::size_t k = 0; k < weights.size(); ++k)
      rows.row(static_cast<Index>(k)) = weights[k].transpose();
    return rows;
  };
  const auto expected = weights_of(plain);
  EXPECT_LT((weights_of(corrected) - expected).norm(), 1e-14 * expected.norm());
}

}  // namespace
}  // namespace mote::test
