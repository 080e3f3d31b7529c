#pragma once

#include <memory>

#include "mote/solvers/krylov.hpp"
#include "mote/solvers/linear_solver.hpp"

namespace mote {

/// Conjugate gradients or BiCGStab with a preconditioner. Iterations start again where the residual
/// of their recurrence is small enough and the true one is not, so what is returned is true.
class KrylovSolver final : public LinearSolver {
 public:
  KrylovSolver(SolverOptions options, std::unique_ptr<Preconditioner> preconditioner)
      : LinearSolver(std::move(options)), preconditioner_(std::move(preconditioner)) {}

  using LinearSolver::solve;
  SolveResult solve(const SparseMatrix& matrix, std::span<const double> right_side,
                    std::span<double> solution, double tolerance) override;

 private:
  void improve(const SparseMatrix& matrix, const Eigen::VectorXd& right_side,
               Eigen::VectorXd& solution, Convergence& convergence, SolveResult& result);

  std::unique_ptr<Preconditioner> preconditioner_;
};

}  // namespace mote
