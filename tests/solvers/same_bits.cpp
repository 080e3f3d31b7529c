#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "mote/solvers/linear_solver.hpp"
#include "support/poisson.hpp"

namespace mote::test {
namespace {

using Values = std::vector<double>;

/// Whatever is left of what was solved before must not matter.
TEST(LinearSolver, GivesTheSameBitsAtAnyNumberOfThreadsAndEveryTime) {
  const int threads_before = omp_get_max_threads();
  const SparseMatrix matrix = poisson_matrix<2>({.side = 100, .left_out = 0.2});
  const SparseMatrix other = poisson_matrix<2>({.side = 50, .seed = 3});
  const Values b = rough_and_smooth(static_cast<Index>(matrix.rows()));
  const Values other_b = rough_and_smooth(static_cast<Index>(other.rows()));
  for (const auto& [name, summary] : solver_names())
    for (const bool symmetric : {true, false}) {
      const auto solver = make_linear_solver(name, {.symmetric = symmetric});
      Values first(b.size());
      omp_set_num_threads(1);
      solver->solve(matrix, b, first);
      for (const int threads : {1, 2, 4}) {
        omp_set_num_threads(threads);
        Values x(b.size()), other_x(other_b.size());
        solver->solve(other, other_b, other_x);
        solver->solve(matrix, b, x);
        EXPECT_EQ(x, first) << name << ", " << threads << " threads";
      }
      // Negative control: a last bit of the right side is noticed.
      Values nudged = b, x(b.size());
      nudged[0] = std::nextafter(nudged[0], 10);
      solver->solve(matrix, nudged, x);
      EXPECT_NE(x, first);
    }
  omp_set_num_threads(threads_before);
}

/// Eigen's packets would have the width of the instruction set.
TEST(LinearSolver, AddsInOneOrderOnAnyMachine) {
  const Eigen::VectorXd x = Eigen::VectorXd::Random(1001), y = Eigen::VectorXd::Random(1001);
  double sum = 0;
  for (int k = 0; k < 1001; ++k) sum += x[k] * y[k];
  EXPECT_EQ(x.dot(y), sum);
}

}  // namespace
}  // namespace mote::test
