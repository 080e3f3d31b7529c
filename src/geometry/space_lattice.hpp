#pragma once

#include <array>

#include "mote/geometry/space_plan.hpp"

namespace mote {

/// A cell of a lattice by its number along each axis; in the plane the last is 0.
using Cell = std::array<Index, 3>;

/// Cells from `first` up to, but without, `end`.
struct CellRange {
  Cell first{0, 0, 0}, end{1, 1, 1};

  bool contains(const Cell& cell) const;
  CellRange hull(const CellRange& other) const;
  /// Number of cells; a double, for it may be more than an Index can count.
  double cells() const;
};

/// The cells of side `spacing` that start at the lower corner of a domain and go on beyond it.
class SpaceLattice {
 public:
  /// Throws InputError if cells do not fit between two sides that need them to.
  explicit SpaceLattice(const SpacePlan& plan);

  /// The middle of a cell.
  Triple place(const Cell& cell) const;

  /// The cells in the domain, and those with the layers around it that walls need: as many as the
  /// operator reaches over, but none beyond periodic sides.
  const CellRange& inside() const { return inside_; }
  const CellRange& around() const { return around_; }

  /// The cells that a region can fill: fluid without an end ends with the domain, walls with the
  /// layers around it; beyond periodic sides there are no walls.
  CellRange range_of(const Region& region) const;

 private:
  void require_whole_cells(const SpacePlan& plan, int axis) const;
  void require_room(const SpacePlan& plan, int axis) const;

  int dimension_;
  Triple lower_;
  std::array<bool, 3> periodic_;
  double spacing_;
  CellRange inside_, around_;
};

}  // namespace mote
