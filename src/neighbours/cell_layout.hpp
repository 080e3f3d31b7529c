#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "mote/particles/vector.hpp"

namespace mote {

/// How space is cut into cells: their width is the reach of the search along every axis but x,
/// where they are finer. Cell floor(x / width) of an axis is the same whatever the cloud, so an
/// order of cells depends on places and reach alone.
///
/// Cells are numbered x fastest within the box of the cloud, with empty cells around it. A box of
/// too many cells is folded: cells that are an `extent` apart share a number, and the number after
/// the last one is the first.
template <int D>
struct CellLayout {
  static constexpr int fineness = 2;  ///< cells along x in a reach

  /// For points at these places, D numbers each, of which there must be at least one.
  CellLayout(std::span<const double> position, double reach);
  CellLayout() = default;

  std::array<double, D> width{}, inverse{};  ///< of a cell
  std::array<double, D> lowest{};            ///< number on the axis of the first cell
  std::array<Index, D> extent{};             ///< number of cells
  Index cells = 0;
  bool is_folded = false;
  std::array<double, D> corner{};  ///< of the box of the cloud
  double rough_extent = 0;         ///< longest edge of that box in rough units
  double per_rough_unit = 0;       ///< inverse of the unit, which is about the reach

  /// Number of the cell on axis d, before folding.
  double on_axis(double x, int d) const { return std::floor(x * inverse[d]); }

  Index folded(double cell_on_axis, int d) const {
    const auto from_lowest = static_cast<Index>(cell_on_axis - lowest[d]);
    return from_lowest < extent[d] ? from_lowest : from_lowest % extent[d];
  }

  /// Squared distances up to 1 of places that are given in single precision, in rough units from
  /// the corner, are wrong by less than this.
  double rough_margin() const { return 0x1p-21 * (1 + rough_extent); }
  /// Whether so few distances fall into that margin that it is worth the while.
  bool has_rough_unit() const { return rough_margin() < 0x1p-11; }
  double in_rough_unit(double length) const { return length * per_rough_unit; }

  /// The cell at a place.
  Index cell_at(const std::array<double, D>& place) const {
    Index cell = 0;
    for (int d = D - 1; d >= 0; --d) cell = cell * extent[d] + folded(on_axis(place[d], d), d);
    return cell;
  }

 private:
  void fold(std::array<double, D> wanted, std::size_t points);
};

extern template struct CellLayout<1>;
extern template struct CellLayout<2>;
extern template struct CellLayout<3>;

}  // namespace mote
