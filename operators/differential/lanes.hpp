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
  const auto [low, high] = std::experimental::split<4, 4>(lanes);
  const auto [first, second] = std::experimental::split<2, 2>(low + high);
  const auto last = first + second;
  return last[0] + last[1];
}

}  // namespace mote
