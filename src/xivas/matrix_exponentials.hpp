#pragma once

#include <Eigen/Core>

namespace mote {

/// P = e^(t A), Q = int_0^t P and R = int_0^t Q: Nadukandi 2014, (18). Of dx/dt = A x + b they give
/// x(t) = x(0) + Q (A x(0) + b), and the integral of x over the time t is t x(0) + R (A x(0) + b).
template <typename Real, int D>
struct MatrixExponentials {
  using Matrix = Eigen::Matrix<Real, D, D>;
  Matrix p, q, r;
};

/// By the Taylor series of R for t / 2^s, with which Q = t I + R A and P = I + Q A cancel nothing,
/// and s doublings of t. The error is a few roundings times the conditioning of each, for strongly
/// decaying matrices as for any. D is 2 or 3, Real double or long double, t not negative.
template <typename Real, int D>
MatrixExponentials<Real, D> matrix_exponentials(const Eigen::Matrix<Real, D, D>& a, Real t);

}  // namespace mote
