#pragma once

#include <cstddef>

#include "mote/particles/parallel.hpp"

namespace mote {

/// Calls f(i) for every i below `size`, on all threads where that is worth it. Elsewhere no
/// parallel region is entered: even one of a single thread takes longer than a few bodies'
/// accelerations.
template <class F>
void for_each_element(std::size_t size, F f) {
  const auto end = static_cast<std::ptrdiff_t>(size);
  if (end < parallel_from) {
    for (std::ptrdiff_t i = 0; i < end; ++i) f(i);
    return;
  }
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < end; ++i) f(i);
}

}  // namespace mote
