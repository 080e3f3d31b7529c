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

  SolveResult solve(const SparseMatrix& matrix, std::span<const double> right_side,
                    std::span<double> solution, Preconditioning preconditioning) override;

 private:
  /// What is to be solved, and the solution so far.
  struct System {
    const SparseMatrix& matrix;
    Eigen::VectorXd right_side, solution;
  };

  void improve(System& system, Preconditioning preconditioning, Convergence& convergence,
               SolveResult& result);
  void prepare(const SparseMatrix& matrix, SolveResult& result);
  PreconditionedSystem preconditioned(const SparseMatrix& matrix) const {
    return {matrix, *preconditioner_, options().singular};
  }
  Eigen::VectorXd residual_of(const System& system) const;
  void iterate(System& system, Eigen::VectorXd residual, Convergence& convergence);

  std::unique_ptr<Preconditioner> preconditioner_;
  Eigen::Index prepared_rows_ = -1;  ///< of the matrix that the preconditioner was made for
};

}  // namespace mote
