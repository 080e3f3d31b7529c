#pragma once

#include <cmath>
#include <numbers>

#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// The Gaussian, h being the paper's gamma (Isshiki 2014, (59) corrected: gamma stands outside the
/// root; ERRATA for D dimensions):
///   h^D W = (2 pi)^(-D/2) exp(-q^2/2).
template <int D>
struct Gauss {
  static constexpr std::string_view name = "gauss";
  static constexpr std::string_view summary = "Gaussian, SPH0 of the paper; h is its gamma";
  static constexpr double usual_length = 1;

  /// From here on the kernel is below one unit of rounding of its value at 0.
  static constexpr double support() { return 8.5; }

  static double value(double q) {
    static const double norm = std::pow(2 * std::numbers::pi, -0.5 * D);
    return inside(q, support()) ? norm * std::exp(-0.5 * q * q) : 0;
  }
  static double slope_over_q(double q) { return -value(q); }
  static double curvature(double q) { return (q * q - 1) * value(q); }
};

}  // namespace mote
