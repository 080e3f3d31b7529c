#include "mote/solvers/strong_part.hpp"

#include <gtest/gtest.h>

#include "support/poisson.hpp"

namespace mote::test {
namespace {

using Eigen::MatrixXd;

SparseMatrix sparse(const MatrixXd& values) { return values.sparseView(); }

TEST(StrongPart, AddsWeakEntriesToTheDiagonalsOfTheirRows) {
  const MatrixXd all{{10, -4, -0.25, 0.2}, {-4, 9, -2, 0}, {-0.25, -2, 5, -1}, {0.2, 0, -1, 3}};
  // The strongest of the rows are 4, 4, 2 and 1: 0.25 is 0.088 of the mean of 4 and 2, 0.2 is 0.1
  // of that of 4 and 1.
  const MatrixXd one{{9.75, -4, 0, 0.2}, {-4, 9, -2, 0}, {0, -2, 4.75, -1}, {0.2, 0, -1, 3}};
  const MatrixXd both{{9.95, -4, 0, 0}, {-4, 9, -2, 0}, {0, -2, 4.75, -1}, {0, 0, -1, 3.2}};
  EXPECT_LT((MatrixXd(strong_part(sparse(all), 0.095)) - one).norm(), 1e-14);
  EXPECT_LT((MatrixXd(strong_part(sparse(all), 0.105)) - both).norm(), 1e-14);
  // Negative control: the threshold 0 leaves every entry.
  EXPECT_EQ((MatrixXd(strong_part(sparse(all), 0)) - all).norm(), 0);
}

TEST(StrongPart, DropsAWeakEntryAtBothPlacesOfASymmetricMatrixOnly) {
  const MatrixXd one_sided{{2, -1, 0}, {-0.05, 1, -1}, {0, -1, 1}};
  const MatrixXd part = strong_part(sparse(one_sided), 0.1);
  EXPECT_EQ(part(0, 1), -1);
  EXPECT_EQ(part(1, 0), 0);
  EXPECT_DOUBLE_EQ(part(1, 1), 0.95);
}

TEST(StrongPart, KeepsRowSumsAndSymmetryOfTheMatricesOfParticles) {
  const SparseMatrix matrix = poisson_matrix<2>({.side = 40, .left_out = 0.2});
  const SparseMatrix part = strong_part(matrix, 0.1);
  EXPECT_LT(part.nonZeros(), 0.8 * static_cast<double>(matrix.nonZeros()));
  EXPECT_EQ((part - SparseMatrix(part.transpose())).norm(), 0);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(matrix.rows());
  const double rounding = 1e-14 * matrix.diagonal().maxCoeff();
  EXPECT_LT(((part - matrix) * ones).cwiseAbs().maxCoeff(), rounding);
  EXPECT_GT(part.diagonal().minCoeff(), 0);
  // Negative control: without the weak entries on the diagonal the sums change.
  SparseMatrix wrong = part;
  for (Index i = 0; i < wrong.rows(); ++i) wrong.coeffRef(i, i) = matrix.coeff(i, i);
  EXPECT_GT(((wrong - matrix) * ones).cwiseAbs().maxCoeff(), 1e3 * rounding);
}

}  // namespace
}  // namespace mote::test
