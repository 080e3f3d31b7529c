#pragma once

#include <algorithm>
#include <vector>

#include "mote/particles/parallel.hpp"

namespace mote {

/// Sum of what `of(i)` gives for i below `count`, in fixed blocks, so that it does not depend on
/// the threads. `sums` is room for those of the blocks.
template <class Value, class Of>
Value fixed_sum(Index count, const Value& zero, Of of, std::vector<Value>& sums) {
  constexpr Index block_size = 1024;
  const Index blocks = (count + block_size - 1) / block_size;
  sums.assign(static_cast<std::size_t>(blocks), zero);
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index block = 0; block < blocks; ++block) {
    Value sum = zero;
    for (Index i = block * block_size; i < std::min(count, (block + 1) * block_size); ++i)
      sum += of(i);
    sums[static_cast<std::size_t>(block)] = sum;
  }
  Value total = zero;
  for (const Value& sum : sums) total += sum;
  return total;
}

/// The same with room of its own.
template <class Value, class Of>
Value fixed_sum(Index count, const Value& zero, Of of) {
  std::vector<Value> sums;
  return fixed_sum(count, zero, of, sums);
}

}  // namespace mote
