#pragma once

#include <numbers>

#include "mote/operators/kernels/kernel.hpp"
#include "mote/operators/kernels/power.hpp"

namespace mote {

/// Wendland's C6 kernel with support 2 h (Wendland 1995; norms of Dehnen & Aly 2012, table 1), with
/// s = q/2 and u = 1 - s:
///   (2 h)^D W = norm u^7 (1 + 7 s + 19 s^2 + 21 s^3) on a line,
///               norm u^8 (1 + 8 s + 25 s^2 + 32 s^3) in 2 and 3 dimensions,
///   norm = 55/32, 78/(7 pi), 1365/(64 pi).
template <int D>
struct WendlandC6 {
  static constexpr std::string_view name = "wendland_c6";
  static constexpr std::string_view summary = "Wendland's C6; h is half its support";
  static constexpr double usual_length = 2;
  static constexpr double norm = D == 1   ? 55.0 / 32
                                 : D == 2 ? 78 / (7 * std::numbers::pi)
                                          : 1365 / (64 * std::numbers::pi);

  static constexpr double support() { return 2; }

  static constexpr double value(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale * (D == 1 ? power<7>(u) * (1 + s * (7 + s * (19 + 21 * s)))
                           : power<8>(u) * (1 + s * (8 + s * (25 + 32 * s))));
  }
  static constexpr double slope_over_q(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale / 4 *
           (D == 1 ? -6 * power<6>(u) * (3 + s * (18 + 35 * s))
                   : -22 * power<7>(u) * (1 + s * (7 + 16 * s)));
  }
  static constexpr double curvature(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale / 4 *
           (D == 1 ? -6 * power<5>(u) * (3 + s * (15 - s * (39 + 315 * s)))
                   : -22 * power<6>(u) * (1 + s * (6 - s * (15 + 160 * s))));
  }

 private:
  static constexpr double scale = norm / power<D>(2);
};

}  // namespace mote
