#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "mote/operators/cores/core.hpp"
#include "mote/operators/cores/incomplete_gamma.hpp"

namespace mote {

/// The Gaussian core, of order 2: zeta = (2 pi)^(-D/2) exp(-rho^2/2). With x = rho^2/2,
///   1 - q = Gamma(D/2, x)/Gamma(D/2);   potential: 2D (ln rho^2 + E1(x))/2, 3D erf(sqrt x)/rho.
struct GaussCore {
  static constexpr std::string_view name = "gauss";
  static constexpr std::string_view summary = "Gaussian; size is its standard deviation";
  static constexpr int order = 2;

  template <int D>
  [[gnu::always_inline]] static Lanes influence(const Lanes& rho_squared) {
    return peak<D> * gamma_series<D>(0.5 * rho_squared);
  }
  template <int D>
  [[gnu::always_inline]] static Lanes influence_slope(const Lanes& rho_squared) {
    return -peak<D> * gamma_series<D + 2>(0.5 * rho_squared);
  }
  template <int D>
  [[gnu::always_inline]] static Lanes blob(const Lanes& rho_squared) {
    constexpr double sphere = (D == 2 ? 2 : 4) * std::numbers::pi;
    return peak<D> / sphere * exponential(-at_most(700, 0.5 * rho_squared));
  }
  template <int D>
  [[gnu::always_inline]] static Lanes potential(const Lanes& rho_squared) {
    const Lanes x = 0.5 * rho_squared;
    if constexpr (D == 2) return 0.5 * smooth_logarithm(x);
    if constexpr (D == 3) return peak<D> * gamma_series<1>(x);
  }

  template <int D>
  static double influence(double rho_squared) {
    return influence<D>(Lanes(rho_squared))[0];
  }
  template <int D>
  static double influence_slope(double rho_squared) {
    return influence_slope<D>(Lanes(rho_squared))[0];
  }
  template <int D>
  static double blob(double rho_squared) {
    return blob<D>(Lanes(rho_squared))[0];
  }
  template <int D>
  static double potential(double rho_squared) {
    return potential<D>(Lanes(rho_squared))[0];
  }

  /// 1 - q + rho q' has its last maximum, more than 1, at rho^2 = D - 1.
  template <int D>
  static double reach(double tolerance) {
    const auto deviation = [](double rho) {
      const double slope = peak<D> * std::exp(-0.5 * rho * rho);  // q'/rho^(D-1)
      const double outside =
          D == 2 ? slope : std::erfc(rho * std::numbers::sqrt2 / 2) + rho * slope;
      return outside + std::pow(rho, D) * slope;
    };
    return end_of_fall(deviation, std::sqrt(D - 1.0), tolerance);
  }

 private:
  /// S_D zeta(0) = S_D (2 pi)^(-D/2); sqrt(2/pi) in 3D.
  template <int D>
  static constexpr double peak = D == 2 ? 1 : std::numbers::sqrt2* std::numbers::inv_sqrtpi;
};

}  // namespace mote
