#include "mote/solvers/krylov_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "mote/particles/failure.hpp"
#include "mote/solvers/system_checks.hpp"

namespace mote {
namespace {

using Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Iterations after which a kept preconditioner gives way to a fresh one: about what making one
/// takes.
constexpr Index worth_keeping = 30;

/// The first few residuals and the last few.
std::string ends_of(const std::vector<double>& history) {
  constexpr std::size_t few = 3;
  std::string text;
  for (std::size_t k = 0; k < history.size(); ++k) {
    if (k == few && history.size() > 2 * few) {
      text += ", ...";
      k = history.size() - few;
    }
    text += fmt::format("{}{:.2g}", k == 0 ? "" : ", ", history[k]);
  }
  return text;
}

/// What may have kept the iterations from going on.
std::string cause_of(const SolverOptions& options, const Convergence& convergence) {
  if (convergence.iterations() >= convergence.most_iterations)
    return "too few iterations are allowed, or the matrix is nearly singular";
  if (!std::isfinite(convergence.residual())) return "numbers beyond the range of double precision";
  if (options.symmetric)
    return "the matrix is not symmetric and positive, or rounding does not allow the tolerance";
  return "the matrix is nearly singular, or rounding does not allow the tolerance";
}

[[noreturn]] void fail(const SolverOptions& options, const Convergence& convergence) {
  throw NumericalFailure(
      fmt::format(
          "{} was not solved: {} iteration{} took the relative residual to {:.2g}, and {:.2g} "
          "was asked for (it went {})",
          options.name, convergence.iterations(), convergence.iterations() == 1 ? "" : "s",
          convergence.residual(), convergence.tolerance, ends_of(convergence.history)),
      {}, cause_of(options, convergence));
}

}  // namespace

void KrylovSolver::prepare(const SparseMatrix& matrix, SolveResult& result) {
  const auto start = Clock::now();
  preconditioner_->prepare(matrix);
  prepared_rows_ = matrix.rows();
  result.setup_seconds += seconds_since(start);
}

VectorXd KrylovSolver::residual_of(const System& system) const {
  VectorXd product;
  preconditioned(system.matrix).multiply(system.solution, product);
  return system.right_side - product;
}

/// Iterates from the true residual, again and again while that helps.
void KrylovSolver::iterate(System& system, VectorXd residual, Convergence& convergence) {
  const auto method = options().symmetric ? conjugate_gradients : bicgstab;
  double before;
  do {
    before = convergence.residual();
    method(preconditioned(system.matrix), residual, system.solution, convergence);
    residual = residual_of(system);
    convergence.correct(residual.norm());
  } while (convergence.may_go_on() && convergence.residual() < 0.5 * before);
}

void KrylovSolver::improve(System& system, Preconditioning preconditioning,
                           Convergence& convergence, SolveResult& result) {
  if (preconditioning == Preconditioning::fresh || !preconditioner_->is_worth_keeping())
    prepared_rows_ = -1;
  const VectorXd residual = residual_of(system);
  convergence.record(residual.norm());
  if (convergence.met()) return;
  if (prepared_rows_ == system.matrix.rows()) {
    const VectorXd guess = system.solution;
    Convergence trial = convergence;
    trial.most_iterations = std::min(worth_keeping, convergence.most_iterations / 2);
    iterate(system, residual, trial);
    convergence.history = trial.history;
    if (convergence.met()) return;
    system.solution = guess;
    convergence.history.push_back(convergence.history.front());
    ++convergence.starts;
  }
  prepare(system.matrix, result);
  iterate(system, residual, convergence);
}

SolveResult KrylovSolver::solve(const SparseMatrix& matrix, std::span<const double> right_side,
                                std::span<double> solution, Preconditioning preconditioning) {
  const auto start = Clock::now();
  require_tolerance(options().tolerance);
  require_sizes(matrix, right_side, solution);
  require_finite(options().name, "right side", right_side);
  require_finite(options().name, "first guess", solution);
  require_positive_diagonal(options().name, matrix);
  System system{matrix, VectorXd::Map(right_side.data(), matrix.rows()),
                VectorXd::Map(solution.data(), matrix.rows())};
  const double whole_norm = system.right_side.norm();
  SolveResult result;
  if (options().singular) {
    result.removed_mean = take_mean_from(system.right_side);
    take_mean_from(system.solution);
  }
  // What rounding leaves of a constant is no right side.
  if (const double norm = system.right_side.norm(); norm > least_tolerance * whole_norm) {
    Convergence convergence{norm, options().tolerance, options().most_iterations};
    improve(system, preconditioning, convergence, result);
    VectorXd::Map(solution.data(), matrix.rows()) = system.solution;
    if (!convergence.met()) fail(options(), convergence);
    result.iterations = convergence.iterations();
    result.residual = convergence.residual();
    result.history = std::move(convergence.history);
  } else {
    std::ranges::fill(solution, 0.0);
  }
  result.solve_seconds = seconds_since(start) - result.setup_seconds;
  return result;
}

}  // namespace mote
