#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <experimental/simd>
#include <limits>
#include <vector>

#include "mote/neighbours/cell_layout.hpp"

namespace mote {

namespace simd = std::experimental;

/// Candidates side by side, as many whatever the type, and one bit for each.
inline constexpr Index scan_lanes = 16;
template <class Real>
using CandidateLanes = simd::fixed_size_simd<Real, scan_lanes>;
using LaneBits = std::uint16_t;

/// Neighbours that are written at a time.
inline constexpr Index list_lanes = 8;
using IndexLanes [[gnu::vector_size(list_lanes * sizeof(Index))]] = Index;

/// For every set of eight lanes the lanes in it, first come first.
struct LaneTable {
  alignas(64) Index lanes[256][list_lanes] = {};

  constexpr LaneTable() {
    for (int bits = 0; bits < 256; ++bits)
      for (int lane = 0, found = 0; lane < list_lanes; ++lane)
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
/// Coordinates have a pack of lanes to spare behind.
template <int D>
struct SortedPoints {
  const CellLayout<D>& layout;
  std::array<const double*, D> place;
  std::array<const float*, D> rough;  ///< place in the layout's rough unit, if it has one
  const Index* cell;                  ///< of each point
  const Index* start;                 ///< place of a cell's first point
  const Index* number;                ///< of each point, to be listed; null where it is its place
  bool others;                        ///< whether there are cells of others
};

/// Finds the neighbours of one receiver after another among the rows of cells around it. Packs of
/// candidates are listed once for all receivers of a cell and then tried without a branch, because
/// a wrong guess of the processor costs as much as some packs.
///
/// Candidates are tried in single precision first. Only where that cannot tell, since one of them
/// is as near to the rim as it rounds, all are tried in double precision.
template <int D>
class CellScan {
 public:
  CellScan(const SortedPoints<D>& points, double reach, double rim)
      : points_(points), greatest_square_(greatest_square(reach * rim)) {
    const double square = points.layout.in_rough_unit(reach) * points.layout.in_rough_unit(reach);
    certain_square_ = static_cast<float>(square - points.layout.rough_margin());
    possible_square_ = static_cast<float>(square + points.layout.rough_margin());
  }

  /// Looks where neighbours of receiver i can be; returns the number of points there.
  std::size_t look_around(Index i) {
    receiver_ = i;
    if (points_.cell[i] != cell_) enter_cell(points_.cell[i]);
    return candidates_;
  }

  /// Writes the neighbours that are there, or the `later` of them alone, those with higher numbers,
  /// in the order of places; returns their end. Writes up to a pack of lanes beyond it. Later ones
  /// can be asked for where points stand in order and the layout is not folded.
  Index* find(Index* list, bool later) {
    if (all_listed_) [[likely]]
      return test(list, later);
    for (Place from{0, begin_[0]}; list_packs(from);) list = test(list, later);
    return list;
  }

 private:
  static constexpr int around = D == 1 ? 1 : (D == 2 ? 3 : 9);  ///< rows, with its own
  static constexpr int packs_at_once = 8;
  static constexpr int most_packs = 128;

  /// A candidate, in its segment.
  struct Place {
    int segment;
    Index next;
  };

  static Index wrapped(Index cell, Index extent) {
    return cell < 0 ? cell + extent : (cell >= extent ? cell - extent : cell);
  }

  void enter_cell(Index cell) {
    const Index row_cells = points_.layout.extent[0];
    if (cell < row_ || cell >= row_ + row_cells) enter_row(cell / row_cells);
    cell_ = cell;
    segments_ = 0;
    for (int r = 0; r < rows_; ++r) add_segment(row_start_[r], cell - row_);
    candidates_ = 0;
    for (int s = 0; s < segments_; ++s)
      candidates_ += static_cast<std::size_t>(end_[s] - begin_[s]);
    Place from{0, begin_[0]};
    list_packs(from);
    all_listed_ = from.segment == segments_;
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
        if (start[0] < start[extent[0]]) ++rows_;
      }
  }

  /// Adds the cells of a row that are as near on x as the search reaches.
  void add_segment(const Index* start, Index cell) {
    const Index extent = points_.layout.extent[0];
    const Index first = cell - CellLayout<D>::fineness, last = cell + CellLayout<D>::fineness;
    if (first >= 0 && last < extent) [[likely]]
      return push(start[first], start[last + 1]);
    push(start[0], start[wrapped(last, extent) + 1]);
    push(start[wrapped(first, extent)], start[extent]);
  }

  void push(Index begin, Index end) {
    begin_[segments_] = begin;
    end_[segments_] = end;
    segments_ += begin < end;
  }

  /// Lists packs from a candidate on, as many as have room; returns whether there was one.
  bool list_packs(Place& from) {
    packs_ = 0;
    own_begin_ = receiver_;
    own_pack_ = most_packs;
    for (; from.segment < segments_; from.next = begin_[++from.segment]) {
      const Index end = end_[from.segment];
      const bool own = from.next <= receiver_ && receiver_ < end;
      own_begin_ = own ? from.next : own_begin_;
      own_pack_ = own ? packs_ : own_pack_;
      for (; from.next < end; from.next += packs_at_once * scan_lanes) {
        if (packs_ > most_packs - packs_at_once) return true;
        add_packs(from.next, end);
      }
    }
    return packs_ > 0;
  }

  /// Lists the packs of up to so many points from j on.
  void add_packs(Index j, Index end) {
    const Index count = std::min<Index>(end - j, packs_at_once * scan_lanes);
    const int added = (count + scan_lanes - 1) / scan_lanes;
    for (int pack = 0; pack < packs_at_once; ++pack) {
      pack_[packs_ + pack] = j + pack * scan_lanes;
      lanes_[packs_ + pack] = 0xffff;
    }
    packs_ += added;
    lanes_[packs_ - 1] = static_cast<LaneBits>(0xffff >> (added * scan_lanes - count));
  }

  /// Writes which points of the listed packs are near enough.
  Index* test(Index* list, bool later) {
    const Index own = std::min(own_pack_ + (receiver_ - own_begin_) / scan_lanes, most_packs);
    first_ = later ? first_later(own) : 0;
    const bool rough = points_.layout.has_rough_unit();
    if (!rough || !compare(points_.rough, possible_square_, certain_square_)) [[unlikely]]
      compare(points_.place, greatest_square_, greatest_square_);
    const unsigned itself = 1u << (receiver_ - own_begin_) % scan_lanes;
    near_[own] &= static_cast<LaneBits>(later ? ~(2 * itself - 1) : ~itself);
    return write(list);
  }

  /// The first of the packs that has points after the receiver, which is in pack `own` if in any.
  int first_later(Index own) const {
    if (own < most_packs) return own;
    return pack_[0] > receiver_ ? 0 : packs_;
  }

  /// Finds which lanes of the packs are possibly near; returns whether all these certainly are.
  template <class Real>
  bool compare(const std::array<const Real*, D>& places, Real possible, Real certain) {
    using Lanes = CandidateLanes<Real>;
    const auto place = places;
    const int packs = packs_;
    std::array<Lanes, D> at;
    for (int d = 0; d < D; ++d) at[d] = place[d][receiver_];
    unsigned doubt = 0;
    for (int k = first_; k < packs; ++k) {
      const Index j = pack_[k];
      const auto squared_difference = [&](int d) {
        const Lanes difference = at[d] - Lanes(place[d] + j, simd::element_aligned);
        return difference * difference;
      };
      Lanes sum = squared_difference(0);
      for (int d = 1; d < D; ++d) sum += squared_difference(d);
      near_[k] = bits_of<Real>(sum <= possible);
      doubt |= near_[k] ^ bits_of<Real>(sum <= certain);
    }
    return doubt == 0;
  }

  /// Writes the points that are near.
  Index* write(Index* list) const {
    fetch_ahead(list);
    const int packs = packs_;
    for (int k = first_; k < packs; ++k) {
      const unsigned near = near_[k] & lanes_[k];
      list = write_lanes(list, near & 255, pack_[k]);
      list = write_lanes(list, near >> list_lanes, pack_[k] + list_lanes);
    }
    return list;
  }

  /// Asks for the memory of the lists some receivers ahead: waiting for it costs a tenth of a
  /// search.
  static void fetch_ahead(const Index* list) {
    constexpr int line = 64 / sizeof(Index), distance = 16 * line;
    for (int k = 0; k < 4; ++k) __builtin_prefetch(list + distance + k * line, 1);
  }

  [[gnu::always_inline]] Index* write_lanes(Index* list, unsigned near, Index first) const {
    IndexLanes found;
    std::memcpy(&found, lane_table.lanes[near], sizeof(found));
    if (points_.number) {
      IndexLanes numbers;
      std::memcpy(&numbers, points_.number + first, sizeof(numbers));
      found = __builtin_shuffle(numbers, found);
    } else {
      found += first;
    }
    std::memcpy(list, &found, sizeof(found));
    return list + std::popcount(near);
  }

  /// One bit a lane. The library keeps the mask of a fixed number of lanes as bits.
  template <class Real>
  static LaneBits bits_of(const typename CandidateLanes<Real>::mask_type& mask) {
    static_assert(sizeof(mask) == sizeof(LaneBits));
    return std::bit_cast<LaneBits>(mask);
  }

  const SortedPoints<D> points_;
  const double greatest_square_;
  float certain_square_, possible_square_;  ///< in the rough unit
  Index receiver_ = 0;
  Index cell_ = -1;                                    ///< of the receiver
  Index row_ = std::numeric_limits<Index>::min() / 2;  ///< first cell of the receiver's row
  int rows_ = 0, segments_ = 0, packs_ = 0;
  int first_ = 0;  ///< pack that is looked at
  std::size_t candidates_ = 0;
  bool all_listed_ = false;  ///< whether the packs are all that are around
  Index own_begin_ = 0;      ///< a point of the receiver's segment
  int own_pack_ = 0;         ///< the pack that starts with it
  std::array<const Index*, 2 * around> row_start_;
  std::array<Index, 4 * around + 1> begin_, end_;  ///< of a row's points within reach
  std::array<Index, most_packs> pack_;             ///< first point of a pack
  std::array<LaneBits, most_packs> lanes_;         ///< lanes that are candidates
  std::array<LaneBits, most_packs + 1> near_;      ///< lanes that are near
};

}  // namespace mote
