#include "mote/xivas/matrix_exponentials.hpp"

#include <cmath>
#include <limits>

namespace mote {
namespace {

template <typename Real, int D>
Real one_norm(const Eigen::Matrix<Real, D, D>& a) {
  return a.cwiseAbs().colwise().sum().maxCoeff();
}

/// The least n with norm^n 2 / (n + 2)! below rounding, norm at most 1/2.
template <typename Real>
int series_degree(Real norm) {
  int n = 0;
  for (Real term = 1; term > std::numeric_limits<Real>::epsilon() / 8; ++n)
    term *= norm / static_cast<Real>(n + 3);
  return n;
}

/// All of B = t A, that is for t = 1: R = sum_n B^n / (n + 2)!, by Horner's rule.
template <typename Real, int D>
MatrixExponentials<Real, D> by_series(const Eigen::Matrix<Real, D, D>& b) {
  using Matrix = Eigen::Matrix<Real, D, D>;
  const Matrix one = Matrix::Identity();
  Matrix r = one;
  for (int n = series_degree(one_norm(b)); n > 0; --n)
    r = one + Matrix(b * r) / static_cast<Real>(n + 2);
  r /= 2;
  const Matrix q = one + b * r;
  return {one + b * q, q, r};
}

/// From unit time to twice of it, called unit time again: R(2) = R + Q + P R, Q(2) = Q + P Q,
/// P(2) = P P.
template <typename Real, int D>
void double_time(MatrixExponentials<Real, D>& of) {
  of.r = ((of.r + of.q + of.p * of.r) / 4).eval();
  of.q = ((of.q + of.p * of.q) / 2).eval();
  of.p = (of.p * of.p).eval();
}

}  // namespace

template <typename Real, int D>
MatrixExponentials<Real, D> matrix_exponentials(const Eigen::Matrix<Real, D, D>& a, Real t) {
  using Matrix = Eigen::Matrix<Real, D, D>;
  const Real norm = one_norm(a) * t;
  const int doublings = norm > Real(0.5) ? std::ilogb(norm) + 2 : 0;
  MatrixExponentials<Real, D> of = by_series(Matrix(a * (t * std::ldexp(Real(1), -doublings))));
  for (int n = 0; n < doublings; ++n) double_time(of);
  of.q *= t;
  of.r *= t * t;
  return of;
}

template MatrixExponentials<double, 2> matrix_exponentials(const Eigen::Matrix2d&, double);
template MatrixExponentials<double, 3> matrix_exponentials(const Eigen::Matrix3d&, double);
template MatrixExponentials<long double, 2> matrix_exponentials(
    const Eigen::Matrix<long double, 2, 2>&, long double);
template MatrixExponentials<long double, 3> matrix_exponentials(
    const Eigen::Matrix<long double, 3, 3>&, long double);

}  // namespace mote
