#pragma once

#include <numbers>

#include "mote/operators/kernels/kernel.hpp"
#include "mote/operators/kernels/power.hpp"

namespace mote {

/// Wendland's C2 kernel with support 2 h (Wendland 1995; norms of Dehnen & Aly 2012, table 1), with
/// s = q/2 and u = 1 - s:
///   (2 h)^D W = norm u^3 (1 + 3 s) on a line,
///               norm u^4 (1 + 4 s) in 2 and 3 dimensions,
///   norm = 5/4, 7/pi, 21/(2 pi).
template <int D>
struct WendlandC2 {
  static constexpr std::string_view name = "wendland_c2";
  static constexpr std::string_view summary = "Wendland's C2; h is half its support";
  static constexpr double usual_length = 2;
  static constexpr double norm = D == 1   ? 5.0 / 4
                                 : D == 2 ? 7 / std::numbers::pi
                                          : 21 / (2 * std::numbers::pi);

  static constexpr double support() { return 2; }

  static constexpr double value(double q) { return value_at(q); }
  static constexpr double slope_over_q(double q) { return slope_over_q_at(q); }
  [[gnu::always_inline]] static Lanes value(const Lanes& q) { return value_at(q); }
  [[gnu::always_inline]] static Lanes slope_over_q(const Lanes& q) { return slope_over_q_at(q); }
  static constexpr double curvature(double q) {
    const double s = q / 2, u = 1 - s;
    if (!inside(q, 2)) return 0;
    return scale / 4 * (D == 1 ? -12 * u * (1 - 3 * s) : -20 * power<2>(u) * (1 - 4 * s));
  }

 private:
  static constexpr double scale = norm / power<D>(2.0);

  template <class Real>
  [[gnu::always_inline]] static constexpr Real value_at(const Real& q) {
    const Real s = 0.5 * q, u = 1 - s;
    return cut(scale * (D == 1 ? power<3>(u) * (1 + 3 * s) : power<4>(u) * (1 + 4 * s)), q, 2);
  }
  template <class Real>
  [[gnu::always_inline]] static constexpr Real slope_over_q_at(const Real& q) {
    const Real u = 1 - 0.5 * q;
    constexpr double factor = scale / 4 * (D == 1 ? -12 : -20);
    return cut(factor * power < D == 1 ? 2 : 3 > (u), q, 2);
  }
};

}  // namespace mote
