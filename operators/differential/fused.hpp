#pragma once

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// a b + c, rounded once: the same bits with and without an instruction for it. (A loop that the
/// compiler makes one instruction; the library's fma falls apart into single numbers.)
[[gnu::always_inline]] inline Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) {
  double factor[lane_count], other[lane_count], sum[lane_count];
  a.copy_to(factor, std::experimental::element_aligned);
  b.copy_to(other, std::experimental::element_aligned);
  c.copy_to(sum, std::experimental::element_aligned);
#pragma GCC unroll 1
  for (std::size_t k = 0; k < lane_count; ++k) sum[k] = __builtin_fma(factor[k], other[k], sum[k]);
  return Lanes(sum, std::experimental::element_aligned);
}

}  // namespace mote
