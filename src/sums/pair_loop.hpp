#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "mote/sums/lane_access.hpp"
#include "mote/sums/pair_kernel.hpp"
#include "mote/sums/pair_shapes.hpp"

namespace mote {

/// Numbers `begin` to `end` - 1 of columns.
struct Range {
  std::size_t begin, end;
};

/// Where a kernel's sources stand: a column of each component and of each number of the strength.
template <PairKernel K>
struct SourceColumns {
  std::array<const double*, K::dimension> position;
  std::array<const double*, K::strengths> strength;
};
template <PairKernel K>
using TargetColumns = std::array<const double*, K::dimension>;
template <PairKernel K>
using OutputColumns = std::array<double*, K::outputs>;

/// How many numbers beyond the end of a column of targets may be read.
inline constexpr std::size_t column_padding = lane_count;

namespace pair_loop {

template <PairKernel K>
using AheadOf = typename decltype(K::shape)::Ahead;

/// So many sources stay in the first cache while all targets pass by; their sum is formed apart
/// and then added, which also keeps the errors of rounding small.
inline constexpr std::size_t sources_at_once = 512;

/// How many packs of targets share a source: enough to work on while others wait for divisions and
/// roots, but not so many that much of what they need does not fit into registers.
template <PairKernel K>
inline constexpr std::size_t packs_at_once =
    std::clamp<std::size_t>(24 / (K::dimension + K::outputs), 1, 4);

/// Adds the first `count` lanes, or all.
[[gnu::always_inline]] inline void add_to_column(const Lanes& sum, double* column,
                                                 std::size_t count) {
  if (count >= lane_count) {
    const Lanes before(column, std::experimental::element_aligned);
    (before + sum).copy_to(column, std::experimental::element_aligned);
  } else {
    double part[lane_count];
    sum.copy_to(part, std::experimental::element_aligned);
    for (std::size_t k = 0; k < count; ++k) column[k] += part[k];
  }
}

/// Adds what the sources do to `Packs` packs of targets, the last of which may be filled in part.
/// Two sources are taken at a time, and what the shape can begin ahead of the next two is begun
/// before these are finished: so divisions and roots never keep the rest waiting.
/// Flattened, as the compiler leaves some operations of lanes as calls where there are many.
template <std::size_t Packs, PairKernel K>
[[gnu::flatten]] void add_to_packs(const K& kernel, const TargetColumns<K>& targets, Range target,
                                   const SourceColumns<K>& sources, Range range,
                                   const OutputColumns<K>& outputs) {
  std::array<std::array<Lanes, K::dimension>, Packs> place;
  std::array<std::array<Lanes, K::outputs>, Packs> sums;
  std::array<AheadOf<K>, Packs> ahead;
  const auto difference = [&](auto p, std::size_t j) __attribute__((always_inline)) {
    std::array<Lanes, K::dimension> result;
    unrolled<K::dimension>([&](auto d) __attribute__((always_inline)) {
      result[d] = place[p][d] - sources.position[d][j];
    });
    return result;
  };
  const auto begun = [&](auto p, std::size_t j) __attribute__((always_inline)) {
    const std::size_t next = std::min(j + 1, range.end - 1);
    return kernel.shape.ahead(
        {square_of<K::dimension>(difference(p, j)), square_of<K::dimension>(difference(p, next))});
  };
  const auto finish = [&](auto p, const AheadOf<K>& now, std::size_t which, std::size_t j)
      __attribute__((always_inline)) {
    std::array<double, K::strengths> strength;
    unrolled<K::strengths>([&](auto s) __attribute__((always_inline)) {
      strength[s] = sources.strength[s][j];
    });
    const auto r = difference(p, j);
    const auto at = kernel.shape.at(now, which, square_of<K::dimension>(r));
    kernel.add(r, strength, at, sums[p]);
  };
  std::size_t j = range.begin;
  unrolled<Packs>([&](auto p) __attribute__((always_inline)) {
    unrolled<K::dimension>([&](auto d) __attribute__((always_inline)) {
      place[p][d] = load(targets[d] + target.begin + p * lane_count);
    });
    unrolled<K::outputs>([&](auto c) __attribute__((always_inline)) { sums[p][c] = 0; });
    ahead[p] = begun(p, j);
  });
  for (; j + 2 < range.end; j += 2)
    unrolled<Packs>([&](auto p) __attribute__((always_inline)) {
      const AheadOf<K> now = ahead[p];
      ahead[p] = begun(p, j + 2);
      finish(p, now, 0, j);
      finish(p, now, 1, j + 1);
    });
  unrolled<Packs>([&](auto p) __attribute__((always_inline)) {
    finish(p, ahead[p], 0, j);
    if (j + 1 < range.end) finish(p, ahead[p], 1, j + 1);
    const std::size_t first = target.begin + p * lane_count;
    unrolled<K::outputs>([&](auto c) __attribute__((always_inline)) {
      add_to_column(sums[p][c], outputs[c] + first, target.end - first);
    });
  });
}

/// The same for any number of targets: as many packs at a time as there are, up to `Packs`.
template <std::size_t Packs, PairKernel K>
void add_in_groups(const K& kernel, const TargetColumns<K>& targets, Range target,
                   const SourceColumns<K>& sources, Range range, const OutputColumns<K>& outputs) {
  while (target.begin < target.end && packs_for(target.end - target.begin) >= Packs) {
    const std::size_t end = std::min(target.begin + Packs * lane_count, target.end);
    add_to_packs<Packs>(kernel, targets, {target.begin, end}, sources, range, outputs);
    target.begin = end;
  }
  if constexpr (Packs > 1)
    if (target.begin < target.end)
      add_in_groups<Packs / 2>(kernel, targets, target, sources, range, outputs);
}

}  // namespace pair_loop

/// Adds to every target of a range what every source of a range does to it, in the order of the
/// sources. Outputs beyond the range are left alone; the columns of targets are read up to
/// `column_padding` numbers beyond it.
template <PairKernel K>
void add_pairs(const K& kernel, const TargetColumns<K>& targets, Range target_range,
               const SourceColumns<K>& sources, Range source_range,
               const OutputColumns<K>& outputs) {
  using namespace pair_loop;
  for (std::size_t first = source_range.begin; first < source_range.end; first += sources_at_once) {
    const Range block{first, std::min(first + sources_at_once, source_range.end)};
    add_in_groups<packs_at_once<K>>(kernel, targets, target_range, sources, block, outputs);
  }
}

}  // namespace mote
