#pragma once

#include <numbers>

#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// The cubic spline, the paper's "optimal kernel", with support h (Isshiki 2014, Table 3; norm
/// from ERRATA):
///   h^D W = norm (1 - 6 q^2 + 6 q^3) for q < 1/2,  norm 2 (1 - q)^3 for q < 1,
///   norm = 4/3, 40/(7 pi), 8/pi.
template <int D>
struct CubicSpline {
  static constexpr std::string_view name = "cubic_spline";
  static constexpr std::string_view summary =
      "cubic spline, SPH2 or optimal kernel of the paper; h is its support";
  static constexpr double usual_length = 8;
  static constexpr double norm = D == 1   ? 4.0 / 3
                                 : D == 2 ? 40 / (7 * std::numbers::pi)
                                          : 8 / std::numbers::pi;

  static constexpr double support() { return 1; }

  static constexpr double value(double q) {
    if (!inside(q, 1)) return 0;
    return q < 0.5 ? norm * (1 - 6 * q * q * (1 - q)) : norm * 2 * (1 - q) * (1 - q) * (1 - q);
  }
  static constexpr double slope_over_q(double q) {
    if (!inside(q, 1)) return 0;
    return q < 0.5 ? norm * (18 * q - 12) : norm * -6 * (1 - q) * (1 - q) / q;
  }
  static constexpr double curvature(double q) {
    if (!inside(q, 1)) return 0;
    return q < 0.5 ? norm * (36 * q - 12) : norm * 12 * (1 - q);
  }
};

}  // namespace mote
