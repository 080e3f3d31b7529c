#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/solvers/sparse_matrix.hpp"

namespace mote {

/// What a solver may rely on, and when it stops.
struct SolverOptions {
  bool symmetric = true;    ///< and positive: conjugate gradients serve, otherwise BiCGStab
  bool singular = false;    ///< every row sums to 0, so that a constant can be added to solutions
  double tolerance = 1e-8;  ///< largest |b - A x| / |b|
  Index most_iterations = 5000;  ///< an iteration of BiCGStab multiplies by the matrix twice
  std::string name = "the linear system";  ///< what messages call it
};

/// How a solution was found.
struct SolveResult {
  Index iterations = 0;
  double residual = 0;          ///< |b - A x| / |b|, computed afresh from the solution
  std::vector<double> history;  ///< |b - A x| / |b| of the first guess and after every iteration;
                                ///< again from the first guess where a kept preconditioner failed
  double removed_mean = 0;      ///< what was taken from all of the right side of a singular system
  double setup_seconds = 0;     ///< for the preconditioner
  double solve_seconds = 0;
};

/// Where the preconditioner of a solution comes from: made for the matrix, or the one that is there
/// already, made for an earlier matrix of the same size. That saves time and costs iterations, few
/// if the matrices differ little.
enum class Preconditioning { fresh, kept };

/// Solves sparse linear systems A x = b. The result has the same bits for any number of threads,
/// and depends on what was solved before only as far as the preconditioner is kept.
///
/// Of a singular system the solution of zero mean is found, for the right side less its mean. (If A
/// is not symmetric, less the constant that makes the system solvable, which is another one.)
class LinearSolver {
 public:
  explicit LinearSolver(SolverOptions options) : options_(std::move(options)) {}
  virtual ~LinearSolver() = default;

  /// Solves for `solution`, which holds the first guess. `matrix` is square with ascending columns.
  /// A preconditioner that was kept and does not do is made afresh.
  /// Throws InputError for a tolerance below `least_tolerance`, std::invalid_argument for sizes
  /// that do not fit, and NumericalFailure where the tolerance is not met or the system cannot be
  /// solved: numbers that are not finite, rows without a positive diagonal (their numbers are the
  /// failure's particles). Then `solution` holds what was reached.
  virtual SolveResult solve(const SparseMatrix& matrix, std::span<const double> right_side,
                            std::span<double> solution,
                            Preconditioning preconditioning = Preconditioning::fresh) = 0;

  const SolverOptions& options() const { return options_; }

  /// Rounding alone leaves residuals of about this size.
  static constexpr double least_tolerance = 1e-14;

 private:
  SolverOptions options_;
};

/// The names of the solvers in this build of mote; the first one is the default.
Choices solver_names();

/// The solver of this name. Throws InputError if this build has none.
std::unique_ptr<LinearSolver> make_linear_solver(std::string_view name, SolverOptions options);

}  // namespace mote
