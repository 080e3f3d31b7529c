#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <experimental/simd>
#include <vector>

#include "mote/neighbours/cell_layout.hpp"

namespace mote {

namespace simd = std::experimental;

/// Eight candidates side by side, and their numbers.
using CandidateLanes = simd::fixed_size_simd<double, 8>;
using IndexLanes = simd::fixed_size_simd<Index, 8>;
inline constexpr Index scan_lanes = 8;

/// For every set of eight lanes the lanes in it, first come first.
struct LaneTable {
  alignas(64) Index lanes[256][scan_lanes] = {};

  constexpr LaneTable() {
    for (int bits = 0; bits < 256; ++bits)
      for (int lane = 0, found = 0; lane < scan_lanes; ++lane)
        if (bits >> lane & 1) lanes[bits][found++] = lane;
  }
};
inline constexpr LaneTable lane_table;

/// The greatest square of a distance that counts as within `reach`: the one whose root does.
inline double greatest_square(double reach) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double square = reach * reach;
  while (std::sqrt(square) > reach) square = std::nextafter(square, 0);
  while (square < infinity && std::sqrt(std::nextafter(square, infinity)) <= reach)
    square = std::nextafter(square, infinity);
  return square;
}

/// What a scan looks at: points sorted by cell, the receivers' cells before those of others.
template <int D>
struct SortedPoints {
  const CellLayout<D>& layout;
  std::array<const double*, D> place;  ///< coordinates, with a pack of lanes to spare behind
  const Index* cell;                   ///< of each point
  const Index* start;                  ///< place of a cell's first point
  bool others;                         ///< whether there are cells of others
};

/// Finds the neighbours of one receiver after another among the rows of cells around it. Loops have
/// fixed lengths and packs of lanes are listed before they are tried, because a wrong guess of the
/// processor at the end of a loop costs as much as some packs.
template <int D>
class CellScan {
 public:
  CellScan(const SortedPoints<D>& points, double reach, double rim)
      : points_(points),
        greatest_square_(greatest_square(reach * rim)),
        wide_square_(reach * reach * (1 + 1e-9)),
        row_(-points.layout.extent[0]) {}

  /// Looks where neighbours of receiver i can be; returns the number of points there.
  std::size_t look_around(Index i) {
    receiver_ = i;
    const Index row_cells = points_.layout.extent[0];
    if (points_.cell[i] < row_ || points_.cell[i] >= row_ + row_cells)
      enter_row(points_.cell[i] / row_cells);
    find_ranges();
    segments_ = 0;
    for (int r = 0; r < rows_; ++r) add_segment(row_start_[r], range_[row_off_[r]]);
    std::size_t candidates = 0;
    for (int s = 0; s < segments_; ++s) candidates += static_cast<std::size_t>(end_[s] - begin_[s]);
    return candidates;
  }

  /// Writes the neighbours that are there, in the order of places; returns their end. Writes up to
  /// a pack of lanes beyond it.
  Index* find(Index* list) {
    int packs = 0;
    for (int s = 0; s < segments_; ++s)
      for (Index j = begin_[s]; j < end_[s]; j += packs_at_once * lane_count) {
        packs += add_packs(j, end_[s], packs);
        if (packs <= most_packs - packs_at_once) continue;
        list = test(packs, list);
        packs = 0;
      }
    return test(packs, list);
  }

 private:
  static constexpr int around = D == 1 ? 1 : (D == 2 ? 3 : 9);          ///< rows, with its own
  static constexpr int padded_around = D == 1 ? 1 : (D == 2 ? 4 : 12);  ///< whole vectors of them
  static constexpr int lane_count = CandidateLanes::size();
  static constexpr int packs_at_once = lane_count;
  static constexpr int most_packs = 128;

  /// Cells of a row from `first` to before `end`, from the row's first cell on.
  struct Range {
    Index first, end;
  };

  static Index wrapped(Index cell, Index extent) {
    return cell < 0 ? cell + extent : (cell >= extent ? cell - extent : cell);
  }

  /// Lists the rows around one, the receivers' first, that are not empty.
  void enter_row(Index row) {
    const auto& extent = points_.layout.extent;
    row_ = row * extent[0];
    rows_ = 0;
    const Index rows_y = D == 1 ? 1 : extent[1 % D];
    const Index rows_z = D < 3 ? 1 : extent[2 % D];
    for (int group = 0; group < (points_.others ? 2 : 1); ++group)
      for (int off = 0; off < around; ++off) {
        const Index y = D == 1 ? 0 : wrapped(row % rows_y + off % 3 - 1, rows_y);
        const Index z = D < 3 ? 0 : wrapped(row / rows_y + off / 3 - 1, rows_z);
        const Index* start =
            points_.start + group * points_.layout.cells + (z * rows_y + y) * extent[0];
        row_start_[rows_] = start;
        row_off_[rows_] = off;
        if (start[0] < start[extent[0]]) ++rows_;
      }
  }

  /// Squares of the least distances along axis d from the receiver to the cells below, with and
  /// above it.
  std::array<double, 3> squared_gaps(int d) const {
    const auto& layout = points_.layout;
    const double x = points_.place[d][receiver_];
    const double edge = layout.on_axis(x, d) * layout.width[d];
    const double below = std::max(0.0, x - edge - layout.slack);
    const double above = std::max(0.0, edge + layout.width[d] - x - layout.slack);
    return {below * below, 0, above * above};
  }

  /// Least squared distances from the receiver to the rows around it.
  std::array<double, padded_around> squared_distances() const {
    std::array<double, padded_around> squares{};
    if constexpr (D > 1) {
      const auto y = squared_gaps(1);
      const auto z = D == 3 ? squared_gaps(D - 1) : std::array<double, 3>{};
      for (int off = 0; off < around; ++off) squares[off] = y[off % 3] + (D == 3 ? z[off / 3] : 0);
    }
    return squares;
  }

  /// Finds which cells of the rows around are within reach: those between two places on x.
  void find_ranges() {
    const double x = points_.place[0][receiver_], inverse = points_.layout.inverse[0];
    const double own = std::floor(x * inverse);
    const auto cell = static_cast<double>(points_.cell[receiver_] - row_);
    const auto squares = squared_distances();
    for (int off = 0; off < padded_around; ++off) {
      const double left = wide_square_ - squares[off];
      const double half = std::sqrt(std::max(left, 0.0));
      const double first = std::floor((x - half) * inverse) - own + cell;
      const double last = std::floor((x + half) * inverse) - own + cell;
      range_[off].first = static_cast<Index>(first);
      range_[off].end = static_cast<Index>(left < 0 ? first : last + 1);
    }
  }

  void add_segment(const Index* start, Range range) {
    const Index extent = points_.layout.extent[0];
    if (range.first >= 0 && range.end <= extent) [[likely]]
      return push(start[range.first], start[range.end]);
    const Index first = wrapped(range.first, extent), end = wrapped(range.end - 1, extent) + 1;
    push(start[0], start[end]);
    push(start[first], start[extent]);
  }

  void push(Index begin, Index end) {
    begin_[segments_] = begin;
    end_[segments_] = end;
    segments_ += begin < end;
  }

  /// Lists the packs of up to so many points from j on; returns their number.
  int add_packs(Index j, Index end, int packs) {
    const Index count = std::min<Index>(end - j, packs_at_once * lane_count);
    const int added = (count + lane_count - 1) / lane_count;
    const IndexLanes begins([&](auto pack) { return j + static_cast<int>(pack) * lane_count; });
    begins.copy_to(pack_.data() + packs, simd::element_aligned);
    std::fill_n(lanes_.data() + packs, packs_at_once, std::uint8_t{255});
    lanes_[packs + added - 1] = static_cast<std::uint8_t>(255 >> (added * lane_count - count));
    const auto self = static_cast<unsigned>(receiver_ - j);
    const bool inside = self < static_cast<unsigned>(count);
    lanes_[inside ? packs + self / lane_count : most_packs] &=
        static_cast<std::uint8_t>(~(1u << self % lane_count));
    return added;
  }

  /// Writes which points of the listed packs are near enough. Works on copies of the members:
  /// what is written to the list could be members as far as the compiler knows.
  Index* test(int packs, Index* list) const {
    const auto place = points_.place;
    const CandidateLanes greatest = greatest_square_;
    std::array<CandidateLanes, D> at;
    for (int d = 0; d < D; ++d) at[d] = place[d][receiver_];
    for (int k = 0; k < packs; ++k) {
      const Index j = pack_[k];
      CandidateLanes sum = 0;
      for (int d = 0; d < D; ++d) {
        const CandidateLanes difference =
            at[d] - CandidateLanes(place[d] + j, simd::element_aligned);
        sum += difference * difference;
      }
      const unsigned near = bits_of(sum <= greatest) & lanes_[k];
      IndexLanes found(lane_table.lanes[near], simd::vector_aligned);
      found += j;
      found.copy_to(list, simd::element_aligned);
      list += std::popcount(near);
    }
    return list;
  }

  /// One bit a lane. The library keeps the mask of a fixed number of lanes as bits.
  static unsigned bits_of(const CandidateLanes::mask_type& mask) {
    static_assert(sizeof(mask) == sizeof(std::uint8_t));
    return std::bit_cast<std::uint8_t>(mask);
  }

  const SortedPoints<D> points_;
  const double greatest_square_;
  const double wide_square_;  ///< beyond it lies no neighbour, however its distance is rounded
  Index receiver_ = 0;
  Index row_;  ///< first cell of the receiver's row
  int rows_ = 0, segments_ = 0;
  std::array<const Index*, 2 * around + 1> row_start_;
  std::array<int, 2 * around + 1> row_off_;
  std::array<Range, padded_around> range_;
  std::array<Index, 4 * around + 1> begin_, end_;   ///< of a row's points within reach
  std::array<Index, most_packs> pack_;              ///< first point of a pack
  std::array<std::uint8_t, most_packs + 1> lanes_;  ///< lanes that are candidates
};

}  // namespace mote
