#include "mote/neighbours/kd_tree.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "support/brute_force.hpp"
#include "support/clouds.hpp"
#include "support/dimensions.hpp"

namespace mote::test {
namespace {

constexpr PairLength pair_lengths[] = {PairLength::mean, PairLength::scatter, PairLength::gather};

template <int D>
NeighbourLists search(const Points<D>& points, const NeighbourRule& rule) {
  NeighbourLists lists;
  KdTreeSearch<D>().find(points, rule, lists);
  return lists;
}

/// The oracle's lists, each in the order of numbers.
template <int D>
NeighbourLists all_pairs(const Points<D>& points, const NeighbourRule& rule) {
  NeighbourLists lists = brute_force(points, rule);
  for (Index i = 0; i < lists.receivers(); ++i)
    std::sort(lists.neighbour.begin() + lists.start[i],
              lists.neighbour.begin() + lists.start[i + 1]);
  return lists;
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

template <class Dimension>
struct KdTreeSearchIn : testing::Test {
  static constexpr int D = Dimension::value;
};

TYPED_TEST_SUITE(KdTreeSearchIn, Dimensions, NameOfDimension);

TYPED_TEST(KdTreeSearchIn, FindsWhatTryingAllPairsFinds) {
  constexpr int D = TestFixture::D;
  for (const auto& [name, points] : clouds<D>())
    for (const PairLength length : pair_lengths)
      for (const double reach : {0.5, 1.0, 2.0, 3.0, 1e6}) {
        const NeighbourRule rule{.support = 2, .smoothing_length = reach / 2, .length = length};
        EXPECT_TRUE(same_lists(points, search(points, rule), all_pairs(points, rule)))
            << name << ", reach " << reach << ", pair length " << static_cast<int>(length);
      }
}

TYPED_TEST(KdTreeSearchIn, FindsCoincidentPointsAtNoReach) {
  constexpr int D = TestFixture::D;
  const auto points = coincident_cloud<D>();
  const NeighbourRule rule{.support = 0};
  const NeighbourLists lists = search(points, rule);
  EXPECT_GT(lists.pairs(), points.receivers);
  EXPECT_TRUE(same_lists(points, lists, all_pairs(points, rule)));
}

/// On a lattice of unit spacing with a support of exactly 2: 4, 12 and 32 points within.
TYPED_TEST(KdTreeSearchIn, CountsANeighbourOnTheRim) {
  constexpr int D = TestFixture::D;
  constexpr std::size_t within[] = {4, 12, 32};
  for (const auto& points : {lattice<D>(), rounded_lattice<D>()}) {
    const NeighbourLists lists = search(points, {.support = 2});
    const auto full =
        std::ranges::count_if(std::views::iota(Index{0}, points.receivers),
                              [&](Index i) { return lists[i].size() == within[D - 1]; });
    EXPECT_GT(full, points.receivers / 20);
    for (Index i = 0; i < points.receivers; ++i) EXPECT_LE(lists[i].size(), within[D - 1]);
  }
}

TYPED_TEST(KdTreeSearchIn, SeesGhostsButGivesThemNoList) {
  constexpr int D = TestFixture::D;
  auto points = random_cloud<D>();
  const NeighbourRule rule{.support = 100};
  points.receivers = 5;
  const NeighbourLists lists = search(points, rule);
  ASSERT_EQ(lists.receivers(), 5);
  for (Index i = 0; i < 5; ++i) EXPECT_EQ(lists[i].back(), points.size() - 1);
  EXPECT_TRUE(same_lists(points, lists, all_pairs(points, rule)));
}

TYPED_TEST(KdTreeSearchIn, TakesCloudsWithoutReceivers) {
  constexpr int D = TestFixture::D;
  auto points = random_cloud<D>();
  points.receivers = 0;
  for (const auto& cloud : {points, Points<D>{}}) {
    const NeighbourLists lists = search(cloud, {.support = 2});
    EXPECT_EQ(lists.receivers(), 0);
    EXPECT_EQ(lists.pairs(), 0);
  }
}

TYPED_TEST(KdTreeSearchIn, ForgetsTheCloudItSearchedBefore) {
  constexpr int D = TestFixture::D;
  const KdTreeSearch<D> used;
  NeighbourLists lists;
  const NeighbourRule rule{.support = 2};
  for (const auto& [name, points] : clouds<D>()) {
    used.find(points, rule, lists);
    EXPECT_TRUE(same_lists(points, lists, search(points, rule))) << name;
  }
}

TYPED_TEST(KdTreeSearchIn, GivesTheSameListsAtAnyNumberOfThreads) {
  constexpr int D = TestFixture::D;
  const auto points =
      jittered_cloud<D>({.side = D == 1 ? 7000 : (D == 2 ? 83 : 19), .variation = 0.5});
  ASSERT_GT(points.receivers, parallel_from);
  const int threads_before = omp_get_max_threads();
  const NeighbourRule rule{.support = 2};
  omp_set_num_threads(1);
  const NeighbourLists lists = search(points, rule);
  for (const int threads : {2, 4}) {
    omp_set_num_threads(threads);
    const NeighbourLists others = search(points, rule);
    EXPECT_EQ(lists.start, others.start) << threads << " threads";
    EXPECT_EQ(lists.neighbour, others.neighbour) << threads << " threads";
  }
  omp_set_num_threads(threads_before);
}

TYPED_TEST(KdTreeSearchIn, RefusesAdjacentPoints) {
  constexpr int D = TestFixture::D;
  EXPECT_THROW(search(random_cloud<D>(), {.adjacent = 1}), std::invalid_argument);
}

TYPED_TEST(KdTreeSearchIn, CheckNoticesAnotherRule) {
  constexpr int D = TestFixture::D;
  const auto points = random_cloud<D>();
  const NeighbourRule rule{.support = 2};
  const NeighbourLists expected = all_pairs(points, rule);
  EXPECT_FALSE(same_lists(points, search(points, {.support = 2.05}), expected));
  EXPECT_FALSE(same_lists(points, search(points, {.support = 1.95}), expected));
  for (const PairLength length : {PairLength::scatter, PairLength::gather})
    EXPECT_FALSE(same_lists(points, search(points, {.support = 2, .length = length}), expected));
  const auto regular = lattice<D>();
  EXPECT_FALSE(
      same_lists(regular, search(regular, {.support = 2 - 1e-9}), all_pairs(regular, rule)));
}

TYPED_TEST(KdTreeSearchIn, CheckNoticesAWrongNeighbour) {
  constexpr int D = TestFixture::D;
  const auto points = random_cloud<D>();
  const NeighbourRule rule{.support = 2};
  NeighbourLists lists = search(points, rule);
  ++lists.neighbour[static_cast<std::size_t>(lists.start[1]) - 1];
  EXPECT_FALSE(same_lists(points, lists, all_pairs(points, rule)));
}

}  // namespace
}  // namespace mote::test
