#pragma once

#include <numbers>

#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// Lucy's kernel with support h (Isshiki 2014, Table 3; norm from ERRATA):
///   h^D W = norm (1 + 3 q) (1 - q)^3,  norm = 5/4, 5/pi, 105/(16 pi).
template <int D>
struct Lucy {
  static constexpr std::string_view name = "lucy";
  static constexpr std::string_view summary = "Lucy's kernel, SPH1 of the paper; h is its support";
  static constexpr double usual_length = 8;
  static constexpr double norm = D == 1   ? 5.0 / 4
                                 : D == 2 ? 5 / std::numbers::pi
                                          : 105 / (16 * std::numbers::pi);

  static constexpr double support() { return 1; }

  static constexpr double value(double q) {
    return inside(q, 1) ? norm * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q) : 0;
  }
  static constexpr double slope_over_q(double q) {
    return inside(q, 1) ? -12 * norm * (1 - q) * (1 - q) : 0;
  }
  static constexpr double curvature(double q) {
    return inside(q, 1) ? -12 * norm * (1 - q) * (1 - 3 * q) : 0;
  }
};

}  // namespace mote
