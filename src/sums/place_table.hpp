#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mote {

/// Finds points by their very places, in O(1): a table with open addresses, as sums of a million
/// points have no time for a general one.
template <int D>
class PlaceTable {
 public:
  /// For these points, D numbers each, of which none is in the table yet.
  explicit PlaceTable(std::span<const double> points)
      : points_(points), slots_(std::bit_ceil(2 * points.size() / D + 1), empty) {}

  /// Puts a point in, unless there is one on its place: then says which.
  std::optional<std::size_t> put(std::size_t point) {
    std::uint32_t& slot = slot_of(points_.subspan(point * D, D));
    if (slot != empty) return slot;
    slot = static_cast<std::uint32_t>(point);
    return {};
  }

  /// The point on this place.
  std::optional<std::size_t> find(std::span<const double> place) {
    const std::uint32_t slot = slot_of(place);
    if (slot == empty) return {};
    return slot;
  }

 private:
  static constexpr std::uint32_t empty = ~std::uint32_t{0};

  /// The slot of a place, or the empty one where it belongs.
  std::uint32_t& slot_of(std::span<const double> place) {
    std::uint64_t hash = 0;
    for (const double x : place) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u;  // -0 is 0
      hash ^= hash >> 32;
    }
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash & mask;
    while (slots_[at] != empty && !std::ranges::equal(points_.subspan(slots_[at] * D, D), place))
      at = (at + 1) & mask;
    return slots_[at];
  }

  std::span<const double> points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace mote
