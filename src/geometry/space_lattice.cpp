#include "mote/geometry/space_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

constexpr double most_cells = 1 << 29;  // along an axis: twice as many still have numbers

Index number_of(double cells) {
  return static_cast<Index>(std::clamp(cells, -most_cells, most_cells));
}

/// Whether the cells along an axis must end at the upper side of the domain.
bool ends_with_a_cell(const SpacePlan& plan, int axis) {
  return plan.periodic[axis] || std::ranges::any_of(plan.walls, [&](const SideWall& wall) {
           return wall.side.axis == axis && wall.side.upper;
         });
}

}  // namespace

bool CellRange::contains(const Cell& cell) const {
  for (int d = 0; d < 3; ++d)
    if (cell[d] < first[d] || cell[d] >= end[d]) return false;
  return true;
}

CellRange CellRange::hull(const CellRange& other) const {
  CellRange hull;
  for (int d = 0; d < 3; ++d) {
    hull.first[d] = std::min(first[d], other.first[d]);
    hull.end[d] = std::max(end[d], other.end[d]);
  }
  return hull;
}

double CellRange::cells() const {
  double cells = 1;
  for (int d = 0; d < 3; ++d) cells *= std::max(0.0, static_cast<double>(end[d]) - first[d]);
  return cells;
}

SpaceLattice::SpaceLattice(const SpacePlan& plan)
    : dimension_(plan.dimension),
      lower_(plan.lower),
      periodic_(plan.periodic),
      spacing_(plan.spacing) {
  const Index layers = number_of(std::ceil(plan.reach));
  for (int d = 0; d < dimension_; ++d) {
    if (ends_with_a_cell(plan, d)) require_whole_cells(plan, d);
    const double rounding = 1e-9;
    inside_.end[d] =
        number_of(std::ceil((plan.upper[d] - plan.lower[d]) / spacing_ - 0.5 - rounding));
    require_room(plan, d);
    const Index beyond = periodic_[d] ? 0 : layers;
    around_.first[d] = -beyond;
    around_.end[d] = inside_.end[d] + beyond;
  }
}

void SpaceLattice::require_whole_cells(const SpacePlan& plan, int axis) const {
  const double length = plan.upper[axis] - plan.lower[axis];
  const double cells = length / spacing_, whole = std::max(1.0, std::round(cells));
  if (std::abs(cells - whole) <= 1e-6 * whole) return;
  throw InputError(
      "particles.spacing",
      fmt::format("between the sides of the domain there are {:.6g} spacings along {}, "
                  "which must be a whole number; the nearest spacing that fits is {:.6g}",
                  cells, axis_names[axis], length / whole));
}

void SpaceLattice::require_room(const SpacePlan& plan, int axis) const {
  const Index cells = inside_.end[axis];
  if (cells < 1)
    throw InputError("particles.spacing",
                     fmt::format("the spacing {:.6g} is longer than the domain along {}", spacing_,
                                 axis_names[axis]));
  if (periodic_[axis] && cells < 2 * plan.reach)
    throw InputError("domain.periodic",
                     fmt::format("the domain is {} spacings long along {} and periodic, and the "
                                 "operator reaches {:.3g} both ways: a particle would see another "
                                 "one twice",
                                 cells, axis_names[axis], plan.reach));
}

Triple SpaceLattice::place(const Cell& cell) const {
  Triple place{};
  for (int d = 0; d < dimension_; ++d) place[d] = lower_[d] + (cell[d] + 0.5) * spacing_;
  return place;
}

CellRange SpaceLattice::range_of(const Region& region) const {
  const bool is_wall = region.body.kind == BodyKind::wall;
  CellRange range = is_wall ? around_ : inside_;
  const Extent extent = region.whole->extent();
  for (int d = 0; d < dimension_; ++d) {
    const double first = std::floor((extent.lower[d] - lower_[d]) / spacing_ - 0.5);
    const double end = std::ceil((extent.upper[d] - lower_[d]) / spacing_ - 0.5) + 1;
    if (std::isfinite(first)) range.first[d] = number_of(first);
    if (std::isfinite(end)) range.end[d] = number_of(end);
    if (!is_wall || !periodic_[d]) continue;
    range.first[d] = std::max(range.first[d], inside_.first[d]);
    range.end[d] = std::min(range.end[d], inside_.end[d]);
  }
  return range;
}

}  // namespace mote
