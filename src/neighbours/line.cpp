#include "mote/neighbours/line.hpp"

#include <algorithm>
#include <numeric>

namespace mote {

void LineSearch::sort(const Points<1>& points) {
  if (static_cast<Index>(order_.size()) != points.size()) {
    order_.resize(static_cast<std::size_t>(points.size()));
    std::iota(order_.begin(), order_.end(), 0);
  }
  const auto before = [&](Index a, Index b) {
    const double x_a = points.position[a], x_b = points.position[b];
    return x_a < x_b || (x_a == x_b && a < b);
  };
  if (!std::ranges::is_sorted(order_, before)) std::ranges::sort(order_, before);
  longest_ = points.length.empty() ? 0 : std::ranges::max(points.length);
}

/// Calls accept(j) for the neighbours of the point at `rank`, from the lowest position up, and
/// returns their number.
template <class Accept>
Index LineSearch::visit(const Points<1>& points, const NeighbourRule& rule, Index rank,
                        Accept accept) const {
  const Index i = order_[rank];
  const auto size = static_cast<Index>(order_.size());
  const auto distance = [&](Index j) {
    return std::abs(points.position[i] - points.position[order_[j]]);
  };
  const auto within = [&](Index j) {
    return rule.adjacent > 0 ? std::abs(j - rank) <= rule.adjacent
                             : rule.accepts(distance(j), points.length[i], longest_) ||
                                   rule.accepts(distance(j), longest_, points.length[i]);
  };
  Index first = rank;
  while (first > 0 && within(first - 1)) --first;
  Index found = 0;
  for (Index j = first; j < size && (j <= rank || within(j)); ++j) {
    const Index point = order_[j];
    const bool accepted =
        j != rank &&
        (rule.adjacent > 0 || rule.accepts(distance(j), points.length[i], points.length[point]));
    if (accepted) accept(found++, point);
  }
  return found;
}

void LineSearch::find(const Points<1>& points, const NeighbourRule& rule, NeighbourLists& lists) {
  sort(points);
  const Index size = points.size();
  lists.restart(points.receivers, static_cast<std::size_t>(size));
#pragma omp parallel if (parallel_from <= size)
  {
    NeighbourLists::Writer writer(lists);
#pragma omp for schedule(static)
    for (Index rank = 0; rank < size; ++rank) {
      if (order_[rank] >= points.receivers) continue;
      const Index count = visit(points, rule, rank, [](Index, Index) {});
      Index* const list = writer.room(static_cast<std::size_t>(count));
      visit(points, rule, rank, [list](Index k, Index point) { list[k] = point; });
      writer.close(order_[rank], list + count);
    }
  }
}

}  // namespace mote
