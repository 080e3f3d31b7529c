#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace mote::test {

inline constexpr PairLength pair_lengths[] = {PairLength::mean, PairLength::scatter,
                                              PairLength::gather};

/// The oracle's lists, each in the order of numbers.
template <int D>
NeighbourLists all_pairs(const Points<D>& points, const NeighbourRule& rule) {
  auto lists = copies_of(brute_force(points, rule));
  for (auto& list : lists) std::ranges::sort(list);
  return NeighbourLists(lists);
}

/// Distances of a receiver's neighbours, the least first.
template <int D>
std::vector<double> distances(const Points<D>& points, const NeighbourLists& lists, Index i) {
  std::vector<double> result;
  for (const Index j : lists[i]) result.push_back((points.at(i) - points.at(j)).norm());
  std::ranges::sort(result);
  return result;
}

/// Whether both have the same lists: the same points, in the same order, at the same distances.
template <int D>
testing::AssertionResult same_lists(const Points<D>& points, const NeighbourLists& found,
                                    const NeighbourLists& expected) {
  if (found.receivers() != points.receivers || expected.receivers() != points.receivers)
    return testing::AssertionFailure() << found.receivers() << " lists";
  for (Index i = 0; i < points.receivers; ++i)
    if (!std::ranges::equal(found[i], expected[i]) ||
        distances(points, found, i) != distances(points, expected, i))
      return testing::AssertionFailure() << "receiver " << i << " has " << found[i].size()
                                         << " neighbours, not " << expected[i].size();
  return testing::AssertionSuccess();
}

/// So many points at places from `place(d)`, of lengths from `length()`; every seventh point is
/// no receiver.
template <int D, class Place, class Length>
Points<D> cloud_of(Index count, Place place, Length length) {
  Points<D> points;
  points.resize(count, count - count / 7);
  for (Index i = 0; i < count; ++i) {
    for (int d = 0; d < D; ++d) points.position[i * D + d] = place(d);
    points.length[i] = length();
  }
  return points;
}

template <int D>
Points<D> random_cloud() {
  Draws draws(21);
  return cloud_of<D>(
      300, [&](int) { return draws.uniform(-4, 4); }, [&] { return draws.uniform(0.1, 1.5); });
}

/// Lengths that vary a thousandfold.
template <int D>
Points<D> graded_cloud() {
  Draws draws(22);
  return cloud_of<D>(
      300, [&](int) { return draws.uniform(-1, 1); },
      [&] { return std::pow(10, draws.uniform(-3, 0)); });
}

template <int D>
Points<D> lattice() {
  return jittered_cloud<D>(
      {.side = D == 1 ? 200 : (D == 2 ? 18 : 7), .jitter = 0, .variation = 0, .seed = 23});
}

/// A lattice whose spacing and places are rounded: many neighbours lie on the rim by intention
/// and beside it by rounding.
template <int D>
Points<D> rounded_lattice() {
  auto points = lattice<D>();
  for (double& x : points.position) x = 0.1 * x - 0.3;
  for (double& length : points.length) length = 0.1;
  return points;
}

template <int D>
Points<D> clustered_cloud() {
  Draws draws(24);
  double spread = 1;
  auto points = cloud_of<D>(
      300, [&](int) { return spread * draws.uniform(0, 1) - 1 / spread; },
      [&] {
        const double length = spread * draws.uniform(0.05, 0.3);
        spread = spread == 1 ? 1e-3 : (spread == 1e-3 ? 1e-7 : 1);
        return length;
      });
  return points;
}

/// More points at a place than a leaf of the tree holds.
template <int D>
Points<D> coincident_cloud() {
  Draws draws(25);
  return cloud_of<D>(
      200, [&](int) { return static_cast<double>(draws.below(D == 1 ? 6 : 2)); },
      [&] { return draws.uniform(0.5, 1.5); });
}

/// All points on a line, parallel to no axis in the first two dimensions.
template <int D>
Points<D> line_cloud() {
  Draws draws(26);
  double s = 0;
  return cloud_of<D>(
      250,
      [&](int d) {
        if (d == 0) s = draws.uniform(-5, 5);
        return d == 2 ? 0.25 : s * (d + 1);
      },
      [&] { return draws.uniform(0.2, 1); });
}

template <int D>
Points<D> single_point() {
  auto points = cloud_of<D>(
      1, [](int) { return 2; }, [] { return 1; });
  return points;
}

template <int D>
using CloudList = std::vector<std::pair<const char*, Points<D>>>;

template <int D>
CloudList<D> clouds() {
  return {{"random", random_cloud<D>()},       {"graded", graded_cloud<D>()},
          {"lattice", lattice<D>()},           {"rounded lattice", rounded_lattice<D>()},
          {"clustered", clustered_cloud<D>()}, {"coincident", coincident_cloud<D>()},
          {"line", line_cloud<D>()},           {"single point", single_point<D>()}};
}

}  // namespace mote::test
