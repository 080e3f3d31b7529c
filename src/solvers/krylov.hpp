#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "mote/solvers/preconditioner.hpp"

namespace mote {

/// Takes the mean of all entries away, and returns it.
inline double take_mean_from(Eigen::VectorXd& x) {
  if (x.size() == 0) return 0;
  const double mean = x.mean();
  x.array() -= mean;
  return mean;
}

/// The matrix and preconditioner that an iteration works with. Of a singular system all that they
/// give is projected to zero mean, which keeps rounding from adding constants without bound.
class PreconditionedSystem {
 public:
  PreconditionedSystem(const SparseMatrix& matrix, Preconditioner& preconditioner, bool singular)
      : matrix_(matrix), preconditioner_(preconditioner), singular_(singular) {}

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const {
    mote::multiply(matrix_, x, product);
    project(product);
  }
  void precondition(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) const {
    preconditioner_.apply(residual, correction);
    project(correction);
  }

 private:
  void project(Eigen::VectorXd& x) const {
    if (singular_) take_mean_from(x);
  }

  const SparseMatrix& matrix_;
  Preconditioner& preconditioner_;
  bool singular_;
};

/// Residuals of an iteration so far, relative to the right side, and when to stop.
struct Convergence {
  double right_side_norm;
  double tolerance;
  Index most_iterations;
  std::vector<double> history = {};  ///< begins with the first guess, at every start
  Index starts = 1;

  Index iterations() const { return static_cast<Index>(history.size()) - starts; }
  double residual() const { return history.back(); }
  bool met() const { return residual() <= tolerance; }
  bool may_go_on() const {
    return !met() && std::isfinite(residual()) && iterations() < most_iterations;
  }
  void record(double residual_norm) { history.push_back(residual_norm / right_side_norm); }
  /// Puts the true residual where the recurrence has gone.
  void correct(double residual_norm) { history.back() = residual_norm / right_side_norm; }
};

/// Improves `solution` while `convergence` may go on and no division by zero is ahead. `residual`
/// must be that of the solution, and what is recorded follows from it by the recurrence, from which
/// the true residual may depart by rounding. Hestenes, Stiefel, J. Res. Natl. Bur. Stand. 49 (1952)
/// 409, with a preconditioner.
void conjugate_gradients(const PreconditionedSystem& system, Eigen::VectorXd& residual,
                         Eigen::VectorXd& solution, Convergence& convergence);

/// The same for matrices that are not symmetric: van der Vorst, SIAM J. Sci. Stat. Comput. 13
/// (1992) 631, preconditioned from the right.
void bicgstab(const PreconditionedSystem& system, Eigen::VectorXd& residual,
              Eigen::VectorXd& solution, Convergence& convergence);

}  // namespace mote
