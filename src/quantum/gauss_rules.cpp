#include "mote/quantum/gauss_rules.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace mote {
namespace {

/// The places are the eigenvalues of the matrix of the recurrence of orthonormal polynomials, and
/// the weights, of sum 1, the squares of the first components of its eigenvectors.
GaussRule rule_of(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  return {solver.eigenvalues(), solver.eigenvectors().row(0).cwiseAbs2().transpose()};
}

}  // namespace

GaussRule gauss_legendre(int count) {
  Eigen::VectorXd beside(count - 1);
  for (int k = 1; k < count; ++k) beside[k - 1] = 0.5 * k / std::sqrt(4.0 * k * k - 1);
  return rule_of(Eigen::VectorXd::Constant(count, 0.5), beside);
}

GaussRule gauss_laguerre(int count) {
  Eigen::VectorXd diagonal(count), beside(count - 1);
  for (int k = 0; k < count; ++k) diagonal[k] = 2.0 * k + 1;
  for (int k = 1; k < count; ++k) beside[k - 1] = k;
  return rule_of(diagonal, beside);
}

}  // namespace mote
