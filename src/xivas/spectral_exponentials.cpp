#include "mote/xivas/spectral_exponentials.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "mote/xivas/piecewise_differences.hpp"

namespace mote {
namespace {

/// The first two are real, or the pair real_part +- i imaginary_part.
struct Eigenvalues {
  std::array<double, 3> real{};
  double real_part = 0, imaginary_part = 0;
  bool has_pair = false;
};

/// (72).
Eigenvalues eigenvalues_of(const Eigen::Matrix2d& a) {
  const double mean = a.trace() / 2, half_gap = (a(0, 0) - a(1, 1)) / 2;
  const double square = half_gap * half_gap + a(0, 1) * a(1, 0), root = std::sqrt(std::abs(square));
  if (square < 0) return {{}, mean, root, true};
  return {{mean - root, mean + root, 0}};
}

/// (74)-(78).
Eigenvalues eigenvalues_of(const Eigen::Matrix3d& a) {
  const double mean = a.trace() / 3;
  const Eigen::Matrix3d b = a - mean * Eigen::Matrix3d::Identity();
  const double q = (b * b).trace() / 6, r = b.determinant() / 2;
  const double discriminant = r * r - q * q * q;
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    const double plus = std::cbrt(r + root), minus = std::cbrt(r - root);
    return {{0, 0, mean + plus + minus},
            mean - (plus + minus) / 2,
            std::numbers::sqrt3 / 2 * std::abs(plus - minus),
            true};
  }
  Eigenvalues of;
  const double angle = q > 0 ? std::acos(std::clamp(r / std::sqrt(q * q * q), -1.0, 1.0)) : 0;
  for (int n = 1; n <= 3; ++n)
    of.real[static_cast<std::size_t>(n - 1)] =
        mean + 2 * std::sqrt(std::max(q, 0.0)) * std::cos((2 * std::numbers::pi * n + angle) / 3);
  return of;
}

/// Coefficients of 1, the linear factor and the product of two, in R for unit time.
using Coefficients = std::array<double, 3>;

/// (57); (190) has the same factors.
Coefficients pair_coefficients(const Eigenvalues& of, SpectralScheme scheme) {
  const double x = of.real_part, y = of.imaginary_part, l = of.real[2];
  const double growth = std::exp(x);
  const auto phi = [&](std::initializer_list<double> nodes) {
    return growth * piecewise_pair_difference(y, std::span(nodes.begin(), nodes.size()));
  };
  const double third = scheme == SpectralScheme::usual ? growth * usual_pair_difference(x, y, l)
                                                       : phi({-x, -x, l - x});
  return {phi({-x}), phi({-x, -x}), third};
}

/// (46), by the differences that two zeros and the nodes have.
Coefficients real_coefficients(std::span<const double> nodes, SpectralScheme scheme) {
  const double third = nodes.size() < 3 ? 0
                       : scheme == SpectralScheme::usual
                           ? usual_r_difference(nodes[0], nodes[1], nodes[2])
                           : piecewise_pair_difference(0, nodes);
  return {piecewise_pair_difference(0, nodes.first(1)),
          piecewise_pair_difference(0, nodes.first(2)), third};
}

}  // namespace

template <int D>
MatrixExponentials<double, D> spectral_exponentials(const Eigen::Matrix<double, D, D>& a, double t,
                                                    SpectralScheme scheme) {
  using Matrix = Eigen::Matrix<double, D, D>;
  const Matrix b = a * t, one = Matrix::Identity();
  Eigenvalues of = eigenvalues_of(b);
  const std::span<double> nodes = std::span(of.real).first(D);
  if (!of.has_pair)
    std::ranges::stable_sort(nodes, {}, [](double value) { return std::abs(value); });
  const double x = of.real_part, y = of.imaginary_part;
  const Coefficients c =
      of.has_pair ? pair_coefficients(of, scheme) : real_coefficients(nodes, scheme);
  Matrix r =
      c[0] * one + c[1] * (of.has_pair ? Matrix(b - 2 * x * one) : Matrix(b - nodes[0] * one));
  if (D == 3)
    r += c[2] * (of.has_pair ? Matrix((b - x * one) * (b - x * one) + y * y * one)
                             : Matrix((b - nodes[0] * one) * (b - nodes[1] * one)));
  const Matrix q = r * b + one;
  return {q * b + one, t * q, t * t * r};
}

template MatrixExponentials<double, 2> spectral_exponentials(const Eigen::Matrix2d&, double,
                                                             SpectralScheme);
template MatrixExponentials<double, 3> spectral_exponentials(const Eigen::Matrix3d&, double,
                                                             SpectralScheme);

}  // namespace mote
