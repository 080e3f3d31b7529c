#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "mote/operators/differential/lanes.hpp"
#include "mote/particles/vector.hpp"

namespace mote {

/// All that a pair term needs of a particle, in one cache line: position, velocity, volume and
/// pressure. A neighbour costs one load from memory, and eight of them turn into lanes in
/// registers.
template <int D>
struct alignas(64) PairLine {
  static constexpr std::size_t position = 0, velocity = D, volume = 2 * D, pressure = 2 * D + 1;

  std::array<double, 8> value{};

  Vec<D> place() const { return Vec<D>::Map(value.data() + position); }
  Vec<D> speed() const { return Vec<D>::Map(value.data() + velocity); }
};

/// The lines of eight neighbours, component by component.
using LineLanes = std::array<Lanes, 8>;

namespace detail {

using EightDoubles [[gnu::vector_size(64)]] = double;

[[gnu::always_inline]] inline Lanes lanes_of(const EightDoubles& eight) {
  alignas(64) double numbers[lane_count];
  *reinterpret_cast<EightDoubles*>(numbers) = eight;
  return Lanes(numbers, std::experimental::vector_aligned);
}

template <int... Place>
[[gnu::always_inline]] inline EightDoubles mix(const EightDoubles& a, const EightDoubles& b) {
  return __builtin_shufflevector(a, b, Place...);
}

}  // namespace detail

/// Turns eight lines into eight packs of lanes: a transposition in three rounds, of pairs, of
/// halves and of wholes. `rows` are the lines' first numbers.
[[gnu::always_inline]] inline LineLanes transposed(
    const std::array<const double*, lane_count>& rows) {
  using detail::EightDoubles, detail::mix, detail::lanes_of;
  const auto row = [&](std::size_t k) { return *reinterpret_cast<const EightDoubles*>(rows[k]); };
  EightDoubles one[8], two[8];
  for (std::size_t k = 0; k < 8; k += 2) {
    const EightDoubles a = row(k), b = row(k + 1);
    one[k] = mix<0, 8, 2, 10, 4, 12, 6, 14>(a, b);
    one[k + 1] = mix<1, 9, 3, 11, 5, 13, 7, 15>(a, b);
  }
  for (std::size_t half : {0, 4})
    for (std::size_t odd : {0, 1}) {
      const EightDoubles a = one[half + odd], b = one[half + odd + 2];
      two[half + odd] = mix<0, 1, 8, 9, 4, 5, 12, 13>(a, b);
      two[half + odd + 2] = mix<2, 3, 10, 11, 6, 7, 14, 15>(a, b);
    }
  LineLanes lanes;
  for (std::size_t k = 0; k < 4; ++k) {
    lanes[k] = lanes_of(mix<0, 1, 2, 3, 8, 9, 10, 11>(two[k], two[k + 4]));
    lanes[k + 4] = lanes_of(mix<4, 5, 6, 7, 12, 13, 14, 15>(two[k], two[k + 4]));
  }
  return lanes;
}

/// The numbers of eight neighbours, and how many of them are valid.
struct EightNeighbours {
  const Index* number;
  std::size_t valid;
};

/// Calls visit(lanes, eight) for the neighbours of receiver i, eight at a time. Where the last
/// eight are not full, the receiver itself stands in for those that are not valid: differences to
/// it vanish, so sums of differences need no mask.
template <int D, class Visit>
[[gnu::always_inline]] inline void for_each_eight(std::span<const PairLine<D>> lines, Index i,
                                                  std::span<const Index> neighbours, Visit visit) {
  const auto visit_eight = [&](const EightNeighbours& eight) __attribute__((always_inline)) {
    std::array<const double*, lane_count> rows;
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      rows[lane] = lines[static_cast<std::size_t>(eight.number[lane])].value.data();
    visit(transposed(rows), eight);
  };
  const std::size_t count = neighbours.size(), full = count - count % lane_count;
  std::array<Index, lane_count> last;
  for (std::size_t lane = 0; lane < lane_count && full < count; ++lane)
    last[lane] = full + lane < count ? neighbours[full + lane] : i;
  for (std::size_t k = 0; k < count; k += lane_count)
    visit_eight({k < full ? neighbours.data() + k : last.data(), std::min(count - k, lane_count)});
}

/// What pair terms have added up for a particle: its acceleration, in the first D numbers, and the
/// rate of the logarithm of its density.
struct alignas(32) PairSums {
  static constexpr std::size_t rate = 3;

  std::array<double, 4> value{};
};

namespace detail {

using FourDoubles [[gnu::vector_size(32)]] = double;

[[gnu::always_inline]] inline EightDoubles doubles_of(const Lanes& lanes) {
  alignas(64) double numbers[lane_count];
  lanes.copy_to(numbers, std::experimental::vector_aligned);
  return *reinterpret_cast<const EightDoubles*>(numbers);
}

}  // namespace detail

/// Takes four packs of lanes, component by component, from the sums of eight particles, one after
/// the other: some may be the same.
[[gnu::always_inline]] inline void take_from(PairSums* sums, const Index* number,
                                             const std::array<Lanes, 4>& lanes) {
  using detail::EightDoubles, detail::FourDoubles, detail::mix, detail::doubles_of;
  EightDoubles one[4], two[4];
  for (std::size_t k = 0; k < 4; k += 2) {
    const EightDoubles a = doubles_of(lanes[k]), b = doubles_of(lanes[k + 1]);
    one[k] = mix<0, 8, 2, 10, 4, 12, 6, 14>(a, b);
    one[k + 1] = mix<1, 9, 3, 11, 5, 13, 7, 15>(a, b);
  }
  for (std::size_t odd : {0, 1}) {
    two[odd] = mix<0, 1, 8, 9, 4, 5, 12, 13>(one[odd], one[odd + 2]);
    two[odd + 2] = mix<2, 3, 10, 11, 6, 7, 14, 15>(one[odd], one[odd + 2]);
  }
  const auto take = [&](Index j, const FourDoubles& four) {
    auto& sum = *reinterpret_cast<FourDoubles*>(sums[j].value.data());
    sum = sum - four;
  };
  for (std::size_t k = 0; k < 4; ++k)
    take(number[k], __builtin_shufflevector(two[k], two[k], 0, 1, 2, 3));
  for (std::size_t k = 0; k < 4; ++k)
    take(number[k + 4], __builtin_shufflevector(two[k], two[k], 4, 5, 6, 7));
}

}  // namespace mote
