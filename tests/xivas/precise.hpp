#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <vector>

namespace mote::precise {

/// Fifty digits, to judge what has sixteen.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

struct Complex {
  Real re = 0, im = 0;
  Complex(Real re = 0, Real im = 0) : re(re), im(im) {}
  Complex(std::complex<double> z) : re(z.real()), im(z.imag()) {}
};
inline Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex operator*(const Real& a, const Complex& b) { return {a * b.re, a * b.im}; }
inline double size(const Complex& z) {
  return static_cast<double>(Real(sqrt(z.re * z.re + z.im * z.im)));
}

/// exp[z1; ...; zk] by the mean value over a simplex (Hermite and Genocchi) expanded about zero:
/// sum_n h_n(z / 2^s) / (n + k - 1)!, and s squarings of the table of all differences.
inline Complex difference(std::vector<Complex> nodes) {
  constexpr int squarings = 8, terms = 40;
  const std::size_t count = nodes.size();
  for (Complex& z : nodes) z = Real(ldexp(Real(1), -squarings)) * z;
  using Table = std::vector<std::vector<Complex>>;
  Table sum(count, std::vector<Complex>(count));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Complex> products(terms);  // h_n of the nodes i to j
    products[0] = Complex(Real(1));
    for (std::size_t j = i; j < count; ++j) {
      for (int n = 1; n < terms; ++n) products[n] = products[n] + nodes[j] * products[n - 1];
      Real factorial = 1;
      for (std::size_t m = 2; m <= j - i; ++m) factorial *= m;
      for (int n = 0; n < terms; factorial *= static_cast<double>(j - i) + ++n)
        sum[i][j] = sum[i][j] + Real(1 / factorial) * products[n];
    }
  }
  for (int s = 0; s < squarings; ++s) {
    const Table half = sum;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i; j < count; ++j) {
        Complex entry;
        for (std::size_t l = i; l <= j; ++l) entry = entry + half[i][l] * half[l][j];
        sum[i][j] = Real(ldexp(Real(1), static_cast<int>(i) - static_cast<int>(j))) * entry;
      }
  }
  return sum[0][count - 1];
}

inline Real difference(const std::vector<double>& nodes) {
  std::vector<Complex> z;
  for (const double node : nodes) z.emplace_back(Real(node));
  return difference(z).re;
}

/// Square matrices of D rows.
template <int D>
using Matrix = std::array<std::array<Real, D>, D>;

template <int D>
Matrix<D> identity() {
  Matrix<D> one{};
  for (int i = 0; i < D; ++i) one[i][i] = 1;
  return one;
}

/// a b + c.
template <int D>
Matrix<D> multiply_add(const Matrix<D>& a, const Matrix<D>& b, const Matrix<D>& c) {
  Matrix<D> sum = c;
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k)
      for (int j = 0; j < D; ++j) sum[i][j] += a[i][k] * b[k][j];
  return sum;
}

template <int D>
Matrix<D> scaled(Matrix<D> a, const Real& by) {
  for (auto& row : a)
    for (Real& entry : row) entry *= by;
  return a;
}

template <int D>
double norm(const Matrix<D>& a) {
  Real sum = 0;
  for (const auto& row : a)
    for (const Real& entry : row) sum += entry * entry;
  return static_cast<double>(Real(sqrt(sum)));
}

template <int D>
Matrix<D> of(const Eigen::Matrix<double, D, D>& a) {
  Matrix<D> copy;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) copy[i][j] = a(i, j);
  return copy;
}

/// P, Q and R of b for unit time: the last three rows of the exponential of the nilpotent
/// extension, summed as three series and doubled as that matrix is squared.
template <int D>
std::array<Matrix<D>, 3> exponentials(const Matrix<D>& b) {
  constexpr int doublings = 10, terms = 24;
  const Matrix<D> one = identity<D>(), small = scaled<D>(b, ldexp(Real(1), -doublings));
  Matrix<D> r = one;
  for (int n = terms; n > 0; --n) r = multiply_add<D>(scaled<D>(small, Real(1) / (n + 2)), r, one);
  r = scaled<D>(r, Real(0.5));
  Matrix<D> q = multiply_add<D>(small, r, one), p = multiply_add<D>(small, q, one);
  for (int n = 0; n < doublings; ++n) {
    const Matrix<D> sum = multiply_add<D>(one, q, r);
    r = scaled<D>(multiply_add<D>(p, r, sum), Real(0.25));
    q = scaled<D>(multiply_add<D>(p, q, q), Real(0.5));
    p = multiply_add<D>(p, p, Matrix<D>{});
  }
  return {p, q, r};
}

/// The relative conditioning of P, Q and R: by how much more than the entries of b each changes,
/// both in the Frobenius norm, from differences over a distance of 1e-20.
template <int D>
std::array<double, 3> conditioning(const Matrix<D>& b) {
  const auto centre = exponentials<D>(b);
  const Real step("1e-20");
  std::array<Real, 3> squares{};
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      Matrix<D> moved = b;
      moved[i][j] += step;
      const auto there = exponentials<D>(moved);
      for (int k = 0; k < 3; ++k)
        for (int m = 0; m < D * D; ++m) {
          const Real slope = (there[k][m / D][m % D] - centre[k][m / D][m % D]) / step;
          squares[k] += slope * slope;
        }
    }
  std::array<double, 3> of;
  for (int k = 0; k < 3; ++k)
    of[k] = static_cast<double>(Real(sqrt(squares[k]))) * norm<D>(b) / norm<D>(centre[k]);
  return of;
}

}  // namespace mote::precise
