#include "mote/neighbours/kd_tree.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <ranges>
#include <stdexcept>

#include "clouds.hpp"
#include "support/dimensions.hpp"

namespace mote::test {
namespace {

template <int D>
NeighbourLists search(const Points<D>& points, const NeighbourRule& rule) {
  NeighbourLists lists;
  KdTreeSearch<D>().find(points, rule, lists);
  return lists;
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
  KdTreeSearch<D> used;
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
    EXPECT_TRUE(lists == search(points, rule)) << threads << " threads";
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
  auto lists = copies_of(search(points, rule));
  ++lists[0].back();
  EXPECT_FALSE(same_lists(points, NeighbourLists(lists), all_pairs(points, rule)));
}

}  // namespace
}  // namespace mote::test
