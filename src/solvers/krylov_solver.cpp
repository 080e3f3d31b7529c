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
          "{} was not solved: {} iterations took the relative residual to {:.2g}, and {:.2g} "
          "was asked for (it went {})",
          options.name, convergence.iterations(), convergence.residual(), convergence.tolerance,
          ends_of(convergence.history)),
      {}, cause_of(options, convergence));
}

}  // namespace

void KrylovSolver::improve(const SparseMatrix& matrix, const VectorXd& right_side,
                           VectorXd& solution, Convergence& convergence, SolveResult& result) {
  const PreconditionedSystem system(matrix, *preconditioner_, options().singular);
  VectorXd product, residual;
  const auto true_residual = [&] {
    system.multiply(solution, product);
    residual = right_side - product;
    return residual.norm();
  };
  convergence.record(true_residual());
  if (convergence.met()) return;

  const auto start = Clock::now();
  preconditioner_->prepare(matrix, options().singular);
  result.setup_seconds = seconds_since(start);
  const auto iterate = options().symmetric ? conjugate_gradients : bicgstab;
  double before;
  do {
    before = convergence.residual();
    iterate(system, residual, solution, convergence);
    convergence.correct(true_residual());
  } while (convergence.may_go_on() && convergence.residual() < 0.5 * before);
}

SolveResult KrylovSolver::solve(const SparseMatrix& matrix, std::span<const double> right_side,
                                std::span<double> solution, double tolerance) {
  const auto start = Clock::now();
  require_tolerance(tolerance);
  require_sizes(matrix, right_side, solution);
  require_finite(options().name, "right side", right_side);
  require_finite(options().name, "first guess", solution);
  require_positive_diagonal(options().name, matrix);
  VectorXd b = VectorXd::Map(right_side.data(), matrix.rows());
  VectorXd x = VectorXd::Map(solution.data(), matrix.rows());
  const double whole_norm = b.norm();
  SolveResult result;
  if (options().singular) {
    result.removed_mean = take_mean_from(b);
    take_mean_from(x);
  }
  // What rounding leaves of a constant is no right side.
  if (const double norm = b.norm(); norm > least_tolerance * whole_norm) {
    Convergence convergence{norm, tolerance, options().most_iterations};
    improve(matrix, b, x, convergence, result);
    VectorXd::Map(solution.data(), x.size()) = x;
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
