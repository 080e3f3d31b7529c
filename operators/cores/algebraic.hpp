#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string_view>

#include "mote/operators/cores/core.hpp"
#include "mote/operators/cores/lane_functions.hpp"

namespace mote {

/// The algebraic cores of orders 2, 4 and 6. With s = 1/(1 + rho^2) and C_j the coefficients of
///   rho^-D = s^(D/2) (1 - s)^(-D/2) = s^(D/2) sum_j C_j s^j,
/// they are q/rho^D = s^(D/2) sum_j mu_j C_j s^j: mu_j = 1 for j <= order/2 makes 1 - q fall as
/// s^(order/2 + 1), and the moment conditions
///   int rho^2k dq ~ sum_i (mu_(i-1) - mu_i) (i - k - 1)!/(i - 1)! = 0,   k = 1 .. order/2 - 1,
/// which are the same in all dimensions, fix as many more. In 2D that is 1 - q = s^2,
/// 3 s^4 - 2 s^3, and 10 s^6 - 12 s^5 + 3 s^4. Order 2 in 3D is the high order algebraic core of
/// Winckelmans & Leonard (1993).
template <int Order>
struct AlgebraicCore {
  static_assert(Order == 2 || Order == 4 || Order == 6);
  static constexpr std::string_view name = Order == 2   ? "algebraic.2"
                                           : Order == 4 ? "algebraic.4"
                                                        : "algebraic.6";
  static constexpr std::string_view summary = "powers of 1/(1 + (r/size)^2), of this order";
  static constexpr int order = Order;

  template <int D, class Real>
  [[gnu::always_inline]] static Real influence(const Real& rho_squared) {
    const Real s = 1 / (1 + rho_squared);
    return half_power<D>(s) * polynomial(of_influence<D>, s);
  }
  template <int D, class Real>
  [[gnu::always_inline]] static Real influence_slope(const Real& rho_squared) {
    const Real s = 1 / (1 + rho_squared);
    return half_power<D>(s) * s * polynomial(of_slope<D>, s);
  }
  template <int D, class Real>
  [[gnu::always_inline]] static Real blob(const Real& rho_squared) {
    const Real s = 1 / (1 + rho_squared);
    return half_power<D>(s) * s * polynomial(of_blob<D>, s);
  }
  template <int D, class Real>
  [[gnu::always_inline]] static Real potential(const Real& rho_squared) {
    const Real s = 1 / (1 + rho_squared);
    const Real sum = polynomial(of_potential<D>, s);
    if constexpr (D == 2) return 0.5 * log_of(Real(1 + rho_squared)) - s * sum;
    if constexpr (D == 3) return root_of(s) * sum;
  }

  /// By 1 - q and rho q' term by term, each term being less than with rho^-2 for s.
  template <int D>
  static double reach(double tolerance) {
    const auto deviation = [](double rho) {
      double sum = 0;
      for (int i = 1; i <= terms; ++i)
        sum += (2 * i + 1) * std::abs(share(i - 1) - share(i)) * expansion<D>(i) *
               std::pow(rho, -2 * i);
      return sum;
    };
    return end_of_fall(deviation, 0, tolerance);
  }

 private:
  static constexpr int terms = Order;
  using Coefficients = std::array<double, terms>;

  /// mu_j.
  static constexpr double share(int j) {
    constexpr std::array<std::array<double, 6>, 3> mu{{{1, 1}, {1, 1, 1, 3}, {1, 1, 1, 1, -2, 10}}};
    return j < terms ? mu[Order / 2 - 1][j] : 0;
  }

  /// C_j.
  template <int D>
  static constexpr double expansion(int j) {
    double product = 1;
    for (int i = 0; i < j; ++i) product = product * (D + 2 * i) / (2 * i + 2);
    return product;
  }

  template <class Coefficient>
  static constexpr Coefficients table(Coefficient coefficient) {
    Coefficients values{};
    for (int j = 0; j < terms; ++j) values[j] = coefficient(j);
    return values;
  }

  template <int D>
  static constexpr Coefficients of_influence = table([](int j) {
    return share(j) * expansion<D>(j);
  });
  template <int D>
  static constexpr Coefficients of_slope = table([](int j) {
    return -(2 * j + D) * share(j) * expansion<D>(j);
  });
  /// D F + rho F' of F = sum_j mu_j C_j s^(j + D/2): 2 i C_i (mu_(i-1) - mu_i) of s^(i + D/2).
  template <int D>
  static constexpr Coefficients of_blob = table([](int j) {
    constexpr double sphere = (D == 2 ? 2 : 4) * std::numbers::pi;
    return 2 * (j + 1) * expansion<D>(j + 1) * (share(j) - share(j + 1)) / sphere;
  });
  /// In 2D of s^(j + 1)/2, the integral of s^(j + 2) over rho^2; in 3D of s^(j + 1/2).
  template <int D>
  static constexpr Coefficients of_potential = table([](int j) {
    if (D == 3) return share(j) * expansion<D>(j) / (2 * j + 1);
    return j + 1 < terms ? share(j + 1) * expansion<D>(j + 1) / (2 * (j + 1)) : 0;
  });

  [[gnu::always_inline]] static double root_of(double x) { return std::sqrt(x); }
  [[gnu::always_inline]] static Lanes root_of(const Lanes& x) { return sqrt(x); }
  static double log_of(double x) { return logarithm(Lanes(x))[0]; }
  [[gnu::always_inline]] static Lanes log_of(const Lanes& x) { return logarithm(x); }

  /// s^(D/2)
  template <int D, class Real>
  [[gnu::always_inline]] static Real half_power(const Real& s) {
    if constexpr (D == 2) return s;
    if constexpr (D == 3) return s * root_of(s);
  }
};

}  // namespace mote
