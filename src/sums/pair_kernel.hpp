#pragma once

#include <array>
#include <concepts>

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// What one source does to eight targets at a time. `difference` is target less source, component
/// by component, `at` the functions of the distance that the kernel's shape gives; what a source
/// does to a target on the very same place must come out finite: 0 for points, what the core says
/// for blobs. `sums` are added to, one for each number that a target gets.
template <class K>
concept PairKernel = requires(const K& kernel, const std::array<Lanes, K::dimension>& difference,
                              const std::array<double, K::strengths>& strength,
                              const typename decltype(K::shape)::At& at,
                              std::array<Lanes, K::outputs>& sums) {
  { kernel.add(difference, strength, at, sums) } -> std::same_as<void>;
};

}  // namespace mote
