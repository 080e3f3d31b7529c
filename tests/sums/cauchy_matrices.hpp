#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <complex>
#include <numbers>
#include <vector>

#include "support/random.hpp"

namespace mote::test {

/// The matrices of Tabanjeh (2014), definition 5.1, small and dense, in the numbers `Real`.
template <class Real>
struct CauchyMatrices {
  using Complex = std::complex<Real>;
  using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

  /// C(a, b), 1/(a_i - b_j).
  static Matrix cauchy(const Vector& a, const Vector& b) {
    return Matrix::NullaryExpr(a.size(), b.size(),
                               [&](auto i, auto j) { return Real(1) / (a[i] - b[j]); });
  }

  /// C(a), with a diagonal of zeros.
  static Matrix degenerate(const Vector& a) {
    return Matrix::NullaryExpr(a.size(), a.size(), [&](auto i, auto j) {
      return i == j ? Complex(0) : Real(1) / (a[i] - a[j]);
    });
  }

  /// V(a), a_i^j.
  static Matrix vandermonde(const Vector& a) {
    Matrix v = Matrix::Ones(a.size(), a.size());
    for (Eigen::Index j = 1; j < a.size(); ++j) v.col(j) = v.col(j - 1).cwiseProduct(a);
    return v;
  }

  /// The Hankel matrix of h_(i + j), with zeros where there is none.
  static Matrix hankel(const Vector& h) {
    return Matrix::NullaryExpr(h.size(), h.size(), [&](auto i, auto j) {
      return i + j < h.size() ? h[i + j] : Complex(0);
    });
  }

  /// The coefficients 1 to n of p_b(x) = prod_j (x - b_j), the first left out.
  static Vector upper_coefficients(const Vector& b) {
    Vector p = Vector::Zero(b.size() + 1);
    p[0] = 1;
    for (Eigen::Index degree = 0; degree < b.size(); ++degree)
      for (Eigen::Index k = degree + 1; k >= 0; --k)
        p[k] = (k > 0 ? p[k - 1] : Complex(0)) - b[degree] * p[k];
    return p.tail(b.size());
  }

  /// D(a, b), the diagonal of p_b(a_i).
  static Matrix polynomial(const Vector& a, const Vector& b) {
    Vector diagonal = Vector::Ones(a.size());
    for (Eigen::Index j = 0; j < b.size(); ++j) diagonal.array() *= a.array() - b[j];
    return diagonal.asDiagonal();
  }

  /// D'(b), the diagonal of p_b'(b_i), the product over the other points.
  static Matrix slope(const Vector& b) {
    Vector diagonal = Vector::Ones(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i)
      for (Eigen::Index j = 0; j < b.size(); ++j)
        if (j != i) diagonal[i] *= b[i] - b[j];
    return diagonal.asDiagonal();
  }

  /// a w_n^i, the scaled roots of unity, (15).
  static Vector roots(Eigen::Index count, Real scale = 1) {
    return Vector::NullaryExpr(count, [&](auto i) {
      return std::polar(scale, 2 * std::numbers::pi_v<Real> * Real(i) / Real(count));
    });
  }

  /// (6), and (13) with q in place of b.
  static Matrix equation_6(const Vector& c, const Vector& d, const Vector& b) {
    return polynomial(c, d).inverse() * polynomial(c, b) * cauchy(c, b) * slope(b).inverse() *
           polynomial(b, d) * cauchy(b, d);
  }

  /// (8), and (14) with q in place of b.
  static Matrix equation_8(const Vector& c, const Vector& d, const Vector& b) {
    return -cauchy(c, b) * polynomial(b, c) * slope(b).inverse() * cauchy(b, d) * polynomial(d, b) *
           polynomial(d, c).inverse();
  }

  /// The largest difference over the largest entry.
  static Real difference(const Matrix& found, const Matrix& right) {
    return (found - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff();
  }
};

/// Points at random radii between two, in turn around the origin, so that none are close.
template <class Real>
typename CauchyMatrices<Real>::Vector points_around(Draws& draws, Eigen::Index count, double inner,
                                                    double outer) {
  return CauchyMatrices<Real>::Vector::NullaryExpr(count, [&](auto i) {
    const double angle = 2 * std::numbers::pi * (double(i) + draws.uniform(0.2, 0.8)) / count;
    const auto place = std::polar(draws.uniform(inner, outer), angle);
    return std::complex<Real>(Real(place.real()), Real(place.imag()));
  });
}

}  // namespace mote::test
