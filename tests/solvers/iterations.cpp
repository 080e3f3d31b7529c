#include <gtest/gtest.h>

#include <cmath>

#include "mote/solvers/linear_solver.hpp"
#include "support/poisson.hpp"

namespace mote::test {
namespace {

/// Iterations for about side^2 unknowns.
double iterations(const std::string& solver, const PoissonShape& shape) {
  const SparseMatrix matrix = poisson_matrix<2>(shape);
  const auto b = rough_and_smooth(static_cast<Index>(matrix.rows()));
  std::vector<double> x(b.size());
  return make_linear_solver(solver, {.singular = !shape.held_top})->solve(matrix, b, x).iterations;
}

/// The exponent of iterations ~ N^exponent from 1e3 to 3e4 unknowns.
double growth(const std::string& solver, PoissonShape shape) {
  shape.side = 32;
  const double few = iterations(solver, shape);
  shape.side = 173;
  return std::log(iterations(solver, shape) / few) / std::log(173.0 * 173 / (32 * 32));
}

/// Conjugate gradients need iterations in proportion to the points across, N^(1/2) in 2D, and
/// multigrid does not.
TEST(LinearSolver, NeedsHardlyMoreIterationsForMoreUnknownsWithMultigrid) {
  const bool multigrid = solver_names().front().name == "hypre";
  for (const double left_out : {0.0, 0.2})
    for (const bool held_top : {true, false}) {
      const PoissonShape shape{.side = 0, .left_out = left_out, .held_top = held_top};
      if (multigrid) {
        EXPECT_LT(growth("hypre", shape), 0.2);
      }
      EXPECT_GT(growth("eigen", shape), 0.35);
    }
}

}  // namespace
}  // namespace mote::test
