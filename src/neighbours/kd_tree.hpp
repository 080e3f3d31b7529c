#pragma once

#include "mote/neighbours/search.hpp"

namespace mote {

/// Neighbour search for any cloud of points in D dimensions, each with its own radius, by
/// nanoflann's k-d tree. Every list is in the order of the points' numbers, so it depends on the
/// state alone. O(N log N). Throws std::invalid_argument for a rule of adjacent points, which only
/// a line can have.
template <int D>
class KdTreeSearch final : public NeighbourSearch<D> {
 public:
  static constexpr std::string_view name = "kd_tree";
  static constexpr std::string_view summary = "k-d tree; for lengths that vary widely";

  void find(const Points<D>& points, const NeighbourRule& rule, NeighbourLists& lists) override;

  /// For every point the mean distance of its `count` nearest others, or of all there are: a
  /// measure of the local spacing.
  std::vector<double> mean_distances(const Points<D>& points, Index count) const;
};

extern template class KdTreeSearch<1>;
extern template class KdTreeSearch<2>;
extern template class KdTreeSearch<3>;

}  // namespace mote
