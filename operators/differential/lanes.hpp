#pragma once

// g++ 12 takes its own undefined registers for uninitialised variables.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <experimental/simd>
#pragma GCC diagnostic pop

namespace mote {

/// Eight numbers side by side. The count is fixed, and sums over the lanes are taken in a fixed
/// tree, so the bits of a result do not depend on the instruction set that it is compiled for.
using Lanes = std::experimental::fixed_size_simd<double, 8>;
inline constexpr std::size_t lane_count = Lanes::size();

/// How many packs of lanes `count` numbers fill; the last may be filled in part.
constexpr std::size_t packs_for(std::size_t count) { return (count + lane_count - 1) / lane_count; }

/// Sum of the lanes, in a fixed order.
inline double sum_of(const Lanes& lanes) {
  const double low = (lanes[0] + lanes[4]) + (lanes[2] + lanes[6]);
  const double high = (lanes[1] + lanes[5]) + (lanes[3] + lanes[7]);
  return low + high;
}

}  // namespace mote
