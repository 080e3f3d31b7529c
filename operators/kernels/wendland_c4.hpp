#pragma once

#include <numbers>

#include "mote/operators/kernels/kernel.hpp"
#include "mote/operators/kernels/power.hpp"

namespace mote {

/// Wendland's C4 kernel with support 2 h (Wendland 1995; norms of Dehnen & Aly 2012, table 1), with
/// s = q/2 and u = 1 - s:
///   (2 h)^D W = norm u^5 (1 + 5 s + 8 s^2) on a line,
///               norm u^6 (1 + 6 s + 35/3 s^2) in 2 and 3 dimensions,
///   norm = 3/2, 9/pi, 495/(32 pi).
template <int D>
struct WendlandC4 {
  static constexpr std::string_view name = "wendland_c4";
  static constexpr std::string_view summary = "Wendland's C4; h is half its support";
  static constexpr double usual_length = 2;
  static constexpr double norm = D == 1   ? 3.0 / 2
                                 : D == 2 ? 9 / std::numbers::pi
                                          : 495 / (32 * std::numbers::pi);

  static constexpr double support() { return 2; }

  static constexpr double value(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale * (D == 1 ? power<5>(u) * (1 + 5 * s + 8 * s * s)
                           : power<6>(u) * (1 + 6 * s + 35.0 / 3 * s * s));
  }
  static constexpr double slope_over_q(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale / 4 *
           (D == 1 ? -14 * power<4>(u) * (1 + 4 * s) : -56.0 / 3 * power<5>(u) * (1 + 5 * s));
  }
  static constexpr double curvature(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale / 4 *
           (D == 1 ? -14 * power<3>(u) * (1 + 3 * s - 24 * s * s)
                   : -56.0 / 3 * power<4>(u) * (1 + 4 * s - 35 * s * s));
  }

 private:
  static constexpr double scale = norm / power<D>(2);
};

}  // namespace mote
