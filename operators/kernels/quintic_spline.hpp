#pragma once

#include <numbers>

#include "mote/operators/kernels/kernel.hpp"
#include "mote/operators/kernels/power.hpp"

namespace mote {

/// The quintic spline with support 3 h (Schoenberg 1946; Morris, Fox & Zhu 1997):
///   h^D W = norm [(3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5], each term while its base is positive,
///   norm = 1/120, 7/(478 pi), 1/(120 pi).
template <int D>
struct QuinticSpline {
  static constexpr std::string_view name = "quintic_spline";
  static constexpr std::string_view summary = "quintic spline; h is a third of its support";
  static constexpr double usual_length = 1.25;
  static constexpr double norm = D == 1   ? 1.0 / 120
                                 : D == 2 ? 7 / (478 * std::numbers::pi)
                                          : 1 / (120 * std::numbers::pi);

  static constexpr double support() { return 3; }

  static constexpr double value(double q) { return inside(q, 3) ? norm * terms<5>(q) : 0; }
  static constexpr double slope_over_q(double q) {
    if (!inside(q, 3)) return 0;
    // Near the centre the terms cancel and leave -120 q + 120 q^3 - 50 q^4, here over q.
    return q < 1 ? norm * (-120 + q * q * (120 - 50 * q)) : -5 * norm * terms<4>(q) / q;
  }
  static constexpr double curvature(double q) { return inside(q, 3) ? 20 * norm * terms<3>(q) : 0; }

 private:
  template <int N>
  static constexpr double terms(double q) {
    return power<N>(3 - q) - (q < 2 ? 6 * power<N>(2 - q) : 0) + (q < 1 ? 15 * power<N>(1 - q) : 0);
  }
};

}  // namespace mote
