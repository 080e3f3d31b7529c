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

/// Eight points side by side.
using PointLanes = std::experimental::fixed_size_simd<double, 8>;
using IndexLanes = std::experimental::fixed_size_simd<Index, 8>;
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

/// Finds the neighbours of one receiver after another among the rows of cells around it.
template <int D>
class CellScan {
 public:
  CellScan(const SortedPoints<D>& points, double reach, double rim)
      : points_(points), square_(greatest_square(reach * rim)), row_(-points.layout.extent[0]) {
    wide_square_ = reach * (1 + 1e-9);
    wide_square_ *= wide_square_;
  }

  /// Looks where neighbours of receiver i can be; returns the number of points there.
  std::size_t look_around(Index i) {
    const Index row_cells = points_.layout.extent[0];
    if (points_.cell[i] < row_ || points_.cell[i] >= row_ + row_cells)
      enter_row(points_.cell[i] / row_cells);
    i_ = i;
    segment_count_ = 0;
    add_segments();
    std::size_t candidates = 0;
    for (int s = 0; s < segment_count_; ++s)
      candidates += static_cast<std::size_t>(segments_[s].end - segments_[s].begin);
    return candidates;
  }

  /// Writes the neighbours that are there, in the order of places; returns their end. Writes a
  /// pack of lanes beyond it.
  Index* find(Index* list) const {
    for (int s = 0; s < segment_count_; ++s)
      for (Index j = segments_[s].begin; j < segments_[s].end; j += scan_lanes)
        list = test(j, segments_[s].end, list);
    return list;
  }

 private:
  static constexpr int most_rows = D == 1 ? 2 : (D == 2 ? 6 : 18);

  /// A row of cells next to the receiver's, and how far it is off along the other axes.
  struct Row {
    const Index* start;
    std::array<int, 2> off;
  };
  struct Segment {
    Index begin, end;
  };

  static Index wrapped(Index cell, Index extent) {
    return cell < 0 ? cell + extent : (cell >= extent ? cell - extent : cell);
  }

  void enter_row(Index row) {
    const auto& extent = points_.layout.extent;
    row_ = row * extent[0];
    row_count_ = 0;
    const Index rows_y = D > 1 ? extent[std::min(1, D - 1)] : 1;
    const Index rows_z = D > 2 ? extent[D - 1] : 1;
    const Index y = row % rows_y, z = row / rows_y;
    for (int group = 0; group < (points_.others ? 2 : 1); ++group)
      for (int off_z = D > 2 ? -1 : 0; off_z <= (D > 2 ? 1 : 0); ++off_z)
        for (int off_y = D > 1 ? -1 : 0; off_y <= (D > 1 ? 1 : 0); ++off_y) {
          const Index other = wrapped(z + off_z, rows_z) * rows_y + wrapped(y + off_y, rows_y);
          const Index* start = points_.start + group * points_.layout.cells + other * extent[0];
          if (start[0] < start[extent[0]]) rows_[row_count_++] = {start, {off_y, off_z}};
        }
  }

  /// Squares of the least distances along axis d from receiver i to the cells below, with and above
  /// it.
  std::array<double, 3> squared_gaps(int d) const {
    const double x = points_.place[d][i_];
    const double edge = points_.layout.on_axis(x, d) * points_.layout.width[d];
    const double below = std::max(0.0, x - edge - points_.layout.slack);
    const double above = std::max(0.0, edge + points_.layout.width[d] - x - points_.layout.slack);
    return {below * below, 0, above * above};
  }

  void add_segments() {
    const auto& layout = points_.layout;
    const double x = points_.place[0][i_];
    const double on_axis = layout.on_axis(x, 0);
    const Index cell = points_.cell[i_] - row_;
    std::array<std::array<double, 3>, 2> gaps{};
    for (int d = 1; d < D; ++d) gaps[d - 1] = squared_gaps(d);
    for (int r = 0; r < row_count_; ++r) {
      const Row& row = rows_[r];
      const double left = wide_square_ - gaps[0][row.off[0] + 1] - gaps[1][row.off[1] + 1];
      if (left < 0) continue;
      const double half = std::sqrt(left);
      add_segment(row.start, cell + static_cast<Index>(layout.on_axis(x - half, 0) - on_axis),
                  cell + static_cast<Index>(layout.on_axis(x + half, 0) - on_axis));
    }
  }

  void add_segment(const Index* start, Index first, Index last) {
    const Index extent = points_.layout.extent[0];
    if (first < 0 || last >= extent) {
      if (last - first + 1 >= extent) {
        first = 0;
        last = extent - 1;
      } else {
        const Index a = wrapped(first, extent), b = wrapped(last, extent);
        push(start[0], start[b + 1]);
        push(start[a], start[extent]);
        return;
      }
    }
    push(start[first], start[last + 1]);
  }
  void push(Index a, Index b) {
    if (a < b) segments_[segment_count_++] = {a, b};
  }

  Index* test(Index j, Index end, Index* list) const {
    namespace simd = std::experimental;
    PointLanes sum = 0;
    for (int d = 0; d < D; ++d) {
      const PointLanes x(points_.place[d] + j, simd::element_aligned);
      const PointLanes difference = points_.place[d][i_] - x;
      sum += difference * difference;
    }
    const auto within = sum <= square_;
    unsigned bits = 0;
    for (int lane = 0; lane < scan_lanes; ++lane)
      bits |= static_cast<unsigned>(within[lane]) << lane;
    if (end - j < scan_lanes) bits &= (1u << (end - j)) - 1;
    const auto self = static_cast<unsigned>(i_ - j);
    if (self < scan_lanes) bits &= ~(1u << self);
    IndexLanes found(lane_table.lanes[bits], simd::vector_aligned);
    found += j;
    found.copy_to(list, simd::element_aligned);
    return list + std::popcount(bits);
  }

  const SortedPoints<D> points_;
  double square_, wide_square_;
  Index row_, i_ = 0;
  int row_count_ = 0, segment_count_ = 0;
  std::array<Row, most_rows> rows_;
  std::array<Segment, 2 * most_rows> segments_;
};

}  // namespace mote
