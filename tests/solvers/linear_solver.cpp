#include "mote/solvers/linear_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include "support/poisson.hpp"

namespace mote::test {
namespace {

using Eigen::VectorXd;
using Values = std::vector<double>;

VectorXd vector(const Values& values) {
  return VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

Values product(const SparseMatrix& matrix, const Values& x) {
  const VectorXd b = matrix * vector(x);
  return {b.begin(), b.end()};
}

double difference(const Values& values, const VectorXd& reference) {
  return (vector(values) - reference).norm() / reference.norm();
}

/// Every solver of this build solves these.
class Solvers : public testing::TestWithParam<std::string> {
 protected:
  static Values solution(const SparseMatrix& matrix, const Values& right_side,
                         const SolverOptions& options, SolveResult* result = nullptr) {
    Values x(right_side.size());
    const auto found = make_linear_solver(GetParam(), options)->solve(matrix, right_side, x);
    EXPECT_LE(found.residual, options.tolerance);
    const VectorXd b = vector(right_side).array() - found.removed_mean;
    if (options.symmetric || !options.singular) {
      EXPECT_NEAR((b - matrix * vector(x)).norm() / b.norm(), found.residual, 1e-13);
    }
    if (result) *result = found;
    return x;
  }
};

/// With a relative residual of 1e-12 the error is at most that times the condition number: the
/// largest eigenvalue is at most twice the largest diagonal, and the smallest about that of the
/// Laplacian, so the number is about 0.5 side^2 on the whole lattice (2D), and a few times that
/// where points are left out.
constexpr double tight = 1e-12;
double bound(Index side) { return 4.0 * side * side * tight; }

TEST_P(Solvers, FindTheSolutionThatIsKnownAndTheDirectOne) {
  constexpr Index side = 100;
  for (const double left_out : {0.0, 0.2}) {
    const SparseMatrix matrix = poisson_matrix<2>({.side = side, .left_out = left_out});
    const Values known = rough_and_smooth(static_cast<Index>(matrix.rows()));
    const Values b = product(matrix, known);
    const Values x = solution(matrix, b, {.tolerance = tight});
    EXPECT_LT(difference(x, vector(known)), bound(side));
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> direct(matrix);
    EXPECT_LT(difference(x, direct.solve(vector(b))), bound(side));

    // Negative control: one pair in twenty thousand with a weight 1 % off is noticed.
    SparseMatrix altered = matrix;
    const Index i = static_cast<Index>(matrix.rows()) / 2, j = row_columns(matrix, i).front();
    const double change = -0.01 * matrix.coeff(i, j);
    for (const auto& [row, column, sign] : {std::tuple(i, i, 1), {j, j, 1}, {i, j, -1}, {j, i, -1}})
      altered.coeffRef(row, column) += sign * change;
    EXPECT_GT(difference(solution(altered, b, {.tolerance = tight}), vector(known)), bound(side));
  }
}

TEST_P(Solvers, StartFromTheGuess) {
  const SparseMatrix matrix = poisson_matrix<2>({.side = 60});
  const Values known = rough_and_smooth(static_cast<Index>(matrix.rows()));
  const Values b = product(matrix, known);
  const auto solver = make_linear_solver(GetParam(), {});
  Values x(b.size());
  const auto cold = solver->solve(matrix, b, x);
  EXPECT_EQ(cold.history.front(), 1);
  const Values reached = x;
  const auto again = solver->solve(matrix, b, x);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.residual, cold.residual);
  EXPECT_EQ(x, reached);
  for (double& value : x) value *= 1.0001;
  const auto warm = solver->solve(matrix, b, x);
  EXPECT_GT(warm.iterations, 0);
  EXPECT_LT(warm.iterations, 0.8 * cold.iterations);
}

TEST_P(Solvers, FindTheSolutionOfZeroMeanOfASingularSystem) {
  constexpr Index side = 100;
  for (const double left_out : {0.0, 0.2}) {
    const SparseMatrix matrix =
        poisson_matrix<2>({.side = side, .left_out = left_out, .held_top = false});
    Values b = rough_and_smooth(static_cast<Index>(matrix.rows()));  // its mean is far from 0
    SolveResult result;
    const Values x = solution(matrix, b, {.singular = true, .tolerance = tight}, &result);
    EXPECT_NEAR(result.removed_mean, vector(b).mean(), 1e-15);
    EXPECT_NEAR(vector(x).mean(), 0, 1e-14 * vector(x).cwiseAbs().maxCoeff());
    // The direct solution: add s to the diagonal entry of one unknown, which makes it 0 and leaves
    // the others as they are, then take the mean.
    SparseMatrix pinned = matrix;
    pinned.coeffRef(0, 0) += matrix.coeff(0, 0);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> direct(pinned);
    VectorXd reference = direct.solve(VectorXd(vector(b).array() - result.removed_mean));
    reference.array() -= reference.mean();
    EXPECT_LT(difference(x, reference), bound(side));
    // Negative control.
    reference[5] += 1e-3 * reference.norm();
    EXPECT_GT(difference(x, reference), bound(side));
  }
}

/// The Poisson matrix with convection along x: entries to the right weigh more than those to the
/// left, on the diagonal as well, so that rows sum to what they did.
SparseMatrix convected(SparseMatrix matrix) {
  for (Index i = 0; i < matrix.rows(); ++i) {
    const auto columns = row_columns(matrix, i);
    const auto values = row_values(matrix, i);
    double added = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (columns[k] == i) continue;
      const double change = (columns[k] > i ? 0.2 : -0.2) * values[k];
      values[k] += change;
      added += change;
    }
    matrix.coeffRef(i, i) -= added;
  }
  return matrix;
}

TEST_P(Solvers, SolveUnsymmetricSystems) {
  constexpr Index side = 100;
  for (const double left_out : {0.0, 0.2}) {
    const SparseMatrix matrix = convected(poisson_matrix<2>({.side = side, .left_out = left_out}));
    const Values known = rough_and_smooth(static_cast<Index>(matrix.rows()));
    const Values b = product(matrix, known);
    const Values x = solution(matrix, b, {.symmetric = false, .tolerance = tight});
    EXPECT_LT(difference(x, vector(known)), bound(side));
    // Negative control: the transpose has another solution.
    const SparseMatrix transposed = matrix.transpose();
    const Values other = solution(transposed, b, {.symmetric = false, .tolerance = tight});
    EXPECT_GT(difference(other, vector(known)), bound(side));
  }
}

/// Less the constant that makes it solvable: that is the last unknown of a bordered system.
TEST_P(Solvers, SolveSingularUnsymmetricSystems) {
  constexpr Index side = 40;
  const SparseMatrix matrix = convected(poisson_matrix<2>({.side = side, .held_top = false}));
  const Index n = static_cast<Index>(matrix.rows());
  const Values b = rough_and_smooth(n);
  const Values x = solution(matrix, b, {.symmetric = false, .singular = true, .tolerance = tight});
  Eigen::SparseMatrix<double> bordered(n + 1, n + 1);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < row_columns(matrix, i).size(); ++k)
      entries.emplace_back(i, row_columns(matrix, i)[k], row_values(matrix, i)[k]);
    entries.emplace_back(i, n, 1);
    entries.emplace_back(n, i, 1);
  }
  bordered.setFromTriplets(entries.begin(), entries.end());
  VectorXd right_side = VectorXd::Zero(n + 1);
  right_side.head(n) = vector(b);
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> direct(bordered);
  const VectorXd reference = direct.solve(right_side);
  EXPECT_LT(difference(x, reference.head(n)), bound(side));
}

INSTANTIATE_TEST_SUITE_P(OfThisBuild, Solvers, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& solver : solver_names()) names.push_back(solver.name);
                           return names;
                         }()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace mote::test
