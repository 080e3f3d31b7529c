#include "mote/solvers/sparse_matrix.hpp"

#include <gtest/gtest.h>

#include "support/poisson.hpp"

namespace mote::test {
namespace {

TEST(MatrixOfZeros, HasTheDiagonalAndReceiversAmongNeighbours) {
  SparseMatrix matrix = matrix_of_zeros(NeighbourLists({{2, 1}, {0, 3, 5}, {}}));
  ASSERT_EQ(matrix.rows(), 3);
  ASSERT_EQ(matrix.cols(), 3);
  const auto columns = [&](Index i) {
    const auto row = row_columns(matrix, i);
    return std::vector<Index>(row.begin(), row.end());
  };
  EXPECT_EQ(columns(0), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(columns(1), (std::vector<Index>{0, 1}));
  EXPECT_EQ(columns(2), (std::vector<Index>{2}));
  EXPECT_EQ(matrix.norm(), 0);
  row_values(matrix, 1)[0] = 7;
  EXPECT_EQ(matrix.coeff(1, 0), 7);
  EXPECT_EQ(row_values(std::as_const(matrix), 1)[0], 7);
}

TEST(MatrixOfZeros, TakesNobody) {
  EXPECT_EQ(matrix_of_zeros(NeighbourLists(std::vector<std::vector<Index>>{})).rows(), 0);
}

/// The matrices of the other tests are what they should be.
TEST(PoissonMatrix, IsSymmetricAndItsRowsSumToZeroUnlessHeld) {
  for (const bool held : {false, true}) {
    const SparseMatrix matrix = poisson_matrix<2>({.side = 40, .held_top = held});
    const SparseMatrix transposed = matrix.transpose();
    EXPECT_EQ((matrix - transposed).norm(), 0);
    const double entries = static_cast<double>(matrix.nonZeros());
    EXPECT_NEAR(entries / static_cast<double>(matrix.rows()), 19, 1);  // 21 but for the rim
    const Eigen::VectorXd sums = matrix * Eigen::VectorXd::Ones(matrix.cols());
    const double largest = matrix.diagonal().maxCoeff();
    const double largest_sum = sums.cwiseAbs().maxCoeff() / largest;
    EXPECT_EQ(largest_sum > 0.1, held);
    EXPECT_EQ(largest_sum > 1e-14, held);
  }
}

}  // namespace
}  // namespace mote::test
