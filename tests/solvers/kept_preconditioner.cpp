#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <random>

#include "mote/solvers/linear_solver.hpp"
#include "support/poisson.hpp"

namespace mote::test {
namespace {

using Eigen::VectorXd;
using Values = std::vector<double>;

constexpr Index side = 60;
constexpr auto kept = Preconditioning::kept;

/// The same points, moved a little further: same pattern or nearly so, other values.
SparseMatrix moved(double jitter) {
  return poisson_matrix<2>({.side = side, .jitter = jitter, .seed = 5});
}

/// The same with the unknowns in another order, far from their old places.
SparseMatrix shuffled(const SparseMatrix& matrix) {
  Eigen::PermutationMatrix<Eigen::Dynamic> order(matrix.rows());
  order.setIdentity();
  auto& places = order.indices();
  std::shuffle(places.begin(), places.end(), std::mt19937(1));
  SparseMatrix result = order * matrix * order.transpose();
  result.makeCompressed();
  return result;
}

double true_residual(const SparseMatrix& matrix, const Values& x, const Values& b) {
  const auto size = static_cast<Eigen::Index>(x.size());
  const VectorXd right = VectorXd::Map(b.data(), size);
  return (right - matrix * VectorXd::Map(x.data(), size)).norm() / right.norm();
}

class KeptPreconditioner : public testing::TestWithParam<std::string> {
 protected:
  const SparseMatrix first_ = moved(0.2), second_ = moved(0.22);
  const Values b_ = rough_and_smooth(static_cast<Index>(first_.rows()));
  const std::unique_ptr<LinearSolver> solver_ = make_linear_solver(GetParam(), {});
  Values x_ = Values(b_.size());
};

TEST_P(KeptPreconditioner, SolvesTheMatrixThatIsThereNow) {
  solver_->solve(first_, b_, x_);
  x_.assign(x_.size(), 0);
  const SolveResult result = solver_->solve(second_, b_, x_, kept);
  EXPECT_LE(true_residual(second_, x_, b_), 1.01e-8);
  // Negative control: that is not the solution of the matrix of before.
  EXPECT_GT(true_residual(first_, x_, b_), 1e-4);
  x_.assign(x_.size(), 0);
  const SolveResult fresh = make_linear_solver(GetParam(), {})->solve(second_, b_, x_);
  EXPECT_LE(result.iterations, 1.5 * fresh.iterations);
  EXPECT_GT(fresh.setup_seconds, 0);
  EXPECT_EQ(result.setup_seconds == 0, GetParam() != "eigen") << "a diagonal is not worth keeping";
}

TEST_P(KeptPreconditioner, GivesWayToAFreshOneWhereItDoesNotDo) {
  solver_->solve(first_, b_, x_);
  x_.assign(x_.size(), 0);
  const SparseMatrix other = shuffled(second_);
  const SolveResult result = solver_->solve(other, b_, x_, kept);
  EXPECT_GT(result.setup_seconds, 0);
  EXPECT_LE(true_residual(other, x_, b_), 1.01e-8);
}

TEST_P(KeptPreconditioner, IsMadeAfreshForAnotherSize) {
  const SparseMatrix small = poisson_matrix<2>({.side = side / 2});
  Values x(static_cast<std::size_t>(small.rows()));
  solver_->solve(first_, b_, x_);
  EXPECT_GT(solver_->solve(small, rough_and_smooth(static_cast<Index>(small.rows())), x, kept)
                .setup_seconds,
            0);
}

/// A run that goes on from a snapshot begins with a fresh one, as the run that made the snapshot
/// does there, and nothing of before may matter; not even whether the fresh one was needed.
TEST_P(KeptPreconditioner, GivesTheSameBitsFromTheLastFreshOneOn) {
  const int threads_before = omp_get_max_threads();
  const auto chain = [&](LinearSolver& solver) {
    Values x(b_.size());
    solver.solve(first_, b_, x);
    solver.solve(first_, b_, x);  // solved already: nothing to prepare
    solver.solve(second_, b_, x, kept);
    return x;
  };
  const Values alone = chain(*make_linear_solver(GetParam(), {}));
  solver_->solve(second_, b_, x_);
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    EXPECT_EQ(chain(*solver_), alone) << threads << " threads";
  }
  omp_set_num_threads(threads_before);
}

INSTANTIATE_TEST_SUITE_P(OfThisBuild, KeptPreconditioner, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& solver : solver_names()) names.push_back(solver.name);
                           return names;
                         }()));

}  // namespace
}  // namespace mote::test
