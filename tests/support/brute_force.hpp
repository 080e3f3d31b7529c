#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mote/neighbours/neighbours.hpp"

namespace mote::test {

/// Distance of two points, in long double.
template <int D>
long double wide_distance(const Points<D>& points, Index i, Index j) {
  long double sum = 0;
  for (int d = 0; d < D; ++d) {
    const long double x = points.position[i * D + d];
    sum += (x - points.position[j * D + d]) * (x - points.position[j * D + d]);
  }
  return std::sqrt(sum);
}

/// Smoothing length of receiver i with neighbour j, in long double.
template <int D>
long double wide_smoothing_length(const Points<D>& points, const NeighbourRule& rule, Index i,
                                  Index j) {
  const long double h_i = points.length[i], h_j = points.length[j];
  if (rule.length == PairLength::gather) return rule.smoothing_length * h_i;
  if (rule.length == PairLength::scatter) return rule.smoothing_length * h_j;
  return rule.smoothing_length * (h_i + h_j) / 2;
}

/// Whether point a stands before point b on a line; equal places stand in the order of numbers.
template <int D>
bool stands_before(const Points<D>& points, Index a, Index b) {
  const double x_a = points.position[a * D], x_b = points.position[b * D];
  return x_a < x_b || (x_a == x_b && a < b);
}

/// Number of points between two points of a line.
template <int D>
Index points_between(const Points<D>& points, Index i, Index j) {
  if (stands_before(points, j, i)) std::swap(i, j);
  Index found = 0;
  for (Index k = 0; k < points.size(); ++k)
    if (stands_before(points, i, k) && stands_before(points, k, j)) ++found;
  return found;
}

/// Whether j is a neighbour of i, decided from the rule's words. The rim counts as inside, with
/// room for the rounding of the distance.
template <int D>
bool are_neighbours(const Points<D>& points, const NeighbourRule& rule, Index i, Index j) {
  if (i == j) return false;
  if (rule.adjacent > 0) return points_between(points, i, j) < rule.adjacent;
  const long double reach = rule.support * wide_smoothing_length(points, rule, i, j);
  return wide_distance(points, i, j) <= reach * (1 + 1e-12L);
}

/// The neighbours of every receiver by trying all pairs, in the order of their first coordinates:
/// the oracle for every search.
template <int D>
NeighbourLists brute_force(const Points<D>& points, const NeighbourRule& rule) {
  std::vector<std::vector<Index>> lists(static_cast<std::size_t>(points.receivers));
  for (Index i = 0; i < points.receivers; ++i) {
    for (Index j = 0; j < points.size(); ++j)
      if (are_neighbours(points, rule, i, j)) lists[i].push_back(j);
    std::ranges::sort(lists[i], [&](Index a, Index b) { return stands_before(points, a, b); });
  }
  return NeighbourLists(lists);
}

/// Copies of the lists, to be altered.
inline std::vector<std::vector<Index>> copies_of(const NeighbourLists& lists) {
  std::vector<std::vector<Index>> copies;
  for (Index i = 0; i < lists.receivers(); ++i)
    copies.emplace_back(lists[i].begin(), lists[i].end());
  return copies;
}

}  // namespace mote::test
