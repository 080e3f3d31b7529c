#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mote/neighbours/cell_layout.hpp"
#include "mote/neighbours/search.hpp"

namespace mote {

/// Points in D dimensions sorted into cells as wide as a search reaches. O(N) while the reach is
/// some spacings. Places must be finite. Nothing is allocated after the first call while the points
/// and the box around them do not grow.
template <int D>
class CellGrid {
 public:
  /// The order of points in space: order[k] is the number of the point that comes k-th. Receivers,
  /// which are the first points, come first; each group is in the order of its cells, x fastest,
  /// and points of a cell in the order of their `id`, or of their number where there is none. Holds
  /// until the next call.
  std::span<const Index> order(std::span<const double> position, Index receivers, double reach,
                               std::span<const Index> id = {});

  /// The points within `reach` of every receiver, the rim included; of two points that are `idle`
  /// (one flag a point, or none at all) neither is in the list of the other. Points can have any
  /// order, and it is much faster where they have the one of `order`. Lists of any order are in the
  /// order of cells; see ListForm.
  void find(std::span<const double> position, Index receivers, double reach,
            std::span<const std::uint8_t> idle, ListForm form, NeighbourLists& lists);

 private:
  void find_cells(std::span<const double> position, Index receivers);
  void sort();
  void sort_by_id(std::span<const Index> id);
  void spread(std::span<const double> position, Index receivers, bool sorted);
  bool spread_in_order(std::span<const double> position, Index receivers);
  void mark_starts();
  Index all_cells() const { return layout_.cells * (others_ ? 2 : 1); }

  CellLayout<D> layout_;
  bool others_ = false;      ///< whether some points are no receivers: they have cells of their own
  std::vector<Index> cell_;  ///< of each point
  std::vector<Index> order_;                  ///< point at each place
  std::vector<Index> count_;                  ///< of points by piece and cell, and where they go
  std::vector<Index> start_;                  ///< place of a cell's first point
  std::array<std::vector<double>, D> place_;  ///< coordinates in order, and some to spare
  std::array<std::vector<float>, D> rough_;   ///< the same in the layout's rough unit
};

/// Neighbour search by a grid of cells, for points whose lengths vary little: it tries all points
/// as near as the longest length reaches. Lists are in the order of cells, points of a cell in the
/// order of their numbers. O(N) for points of one length. Throws std::invalid_argument for a rule
/// of adjacent points, which only a line can have.
template <int D>
class CellGridSearch final : public NeighbourSearch<D> {
 public:
  static constexpr std::string_view name = "cell_grid";
  static constexpr std::string_view summary =
      "grid of cells; the fastest where lengths vary little";

  void find(const Points<D>& points, const NeighbourRule& rule, NeighbourLists& lists) override;

 private:
  CellGrid<D> grid_;
};

extern template class CellGrid<1>;
extern template class CellGrid<2>;
extern template class CellGrid<3>;
extern template class CellGridSearch<1>;
extern template class CellGridSearch<2>;
extern template class CellGridSearch<3>;

}  // namespace mote
