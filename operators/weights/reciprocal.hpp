#pragma once

#include <string_view>

namespace mote {

/// The MPS weight of Isshiki (2014), Table 3, after Koshizuka & Oka (1996):
///   w = h/r - 1 for r < h, as a function of q = r/h.
/// Singular at q = 0 and not normalised: the operator's own sums n and lambda do that.
struct Reciprocal {
  static constexpr std::string_view name = "reciprocal";
  static constexpr std::string_view summary = "h/r - 1, the weight of MPS; h is its support";
  static constexpr double usual_length = 2;
  static constexpr double support = 1;

  static constexpr double value(double q) { return q < support ? 1 / q - 1 : 0; }
};

}  // namespace mote
