#pragma once

#include <vector>

#include "mote/neighbours/search.hpp"

namespace mote {

/// Neighbour search on a line: sorts the points, then sweeps from each receiver to both sides.
/// Lists run from the lowest to the highest position, equal positions by number. O(N log N), or
/// O(N) when the order of the last call still holds.
class LineSearch final : public NeighbourSearch<1> {
 public:
  static constexpr std::string_view name = "line";
  static constexpr std::string_view summary =
      "sorted line; the only one for operators of adjacent points";

  void find(const Points<1>& points, const NeighbourRule& rule, NeighbourLists& lists) override;

 private:
  void sort(const Points<1>& points);
  template <class Accept>
  Index visit(const Points<1>& points, const NeighbourRule& rule, Index rank, Accept accept) const;

  std::vector<Index> order_;  ///< point at each rank
  double longest_ = 0;        ///< longest local spacing
};

}  // namespace mote
