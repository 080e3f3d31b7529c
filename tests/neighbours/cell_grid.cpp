#include "mote/neighbours/cell_grid.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "clouds.hpp"
#include "support/dimensions.hpp"

namespace mote::test {
namespace {

template <int D>
NeighbourLists search(const Points<D>& points, const NeighbourRule& rule) {
  NeighbourLists lists;
  CellGridSearch<D>().find(points, rule, lists);
  return lists;
}

/// The same lists, each in the order of numbers.
NeighbourLists sorted(const NeighbourLists& lists) {
  auto copies = copies_of(lists);
  for (auto& list : copies) std::ranges::sort(list);
  return NeighbourLists(copies);
}

/// Points of one length with a few of them very far away, and far from each other.
template <int D>
Points<D> cloud_with_outliers() {
  auto points = jittered_cloud<D>({.side = D == 1 ? 200 : (D == 2 ? 16 : 7), .variation = 0});
  for (Index i = 0; i < 6; ++i)
    for (int d = 0; d < D; ++d)
      points.position[(5 * i + 1) * D + d] = (d + i) % 2 == 0 ? 1e9 + i / 2 : -1e7 * i;
  return points;
}

/// A diagonal of space that is much longer than points reach.
template <int D>
Points<D> diagonal() {
  auto points = line_cloud<D>();
  for (Index i = 0; i < points.size(); ++i)
    for (int d = 0; d < D; ++d) points.position[i * D + d] = 1e4 + 0.5 * i;
  std::ranges::fill(points.length, 1);
  return points;
}

/// Points of the same length that all have the same last coordinate.
template <int D>
Points<D> plane() {
  auto points = random_cloud<D>();
  for (Index i = 0; i < points.size(); ++i) points.position[i * D + D - 1] = -3;
  std::ranges::fill(points.length, 0.8);
  return points;
}

template <int D>
CloudList<D> clouds_for_grids() {
  auto list = clouds<D>();
  list.push_back({"outliers", cloud_with_outliers<D>()});
  list.push_back({"diagonal", diagonal<D>()});
  list.push_back({"plane", plane<D>()});
  return list;
}

template <class Dimension>
struct CellGridIn : testing::Test {
  static constexpr int D = Dimension::value;
};

TYPED_TEST_SUITE(CellGridIn, Dimensions, NameOfDimension);

TYPED_TEST(CellGridIn, FindsWhatTryingAllPairsFinds) {
  constexpr int D = TestFixture::D;
  for (const auto& [name, points] : clouds_for_grids<D>())
    for (const PairLength length : pair_lengths)
      for (const double reach : {0.5, 1.0, 2.0, 3.0, 1e6}) {
        const NeighbourRule rule{.support = 2, .smoothing_length = reach / 2, .length = length};
        EXPECT_TRUE(same_lists(points, sorted(search(points, rule)), all_pairs(points, rule)))
            << name << ", reach " << reach << ", pair length " << static_cast<int>(length);
      }
}

TYPED_TEST(CellGridIn, FindsCoincidentPointsAtNoReach) {
  constexpr int D = TestFixture::D;
  const auto points = coincident_cloud<D>();
  const NeighbourLists lists = search(points, {.support = 0});
  EXPECT_GT(lists.pairs(), points.receivers);
  EXPECT_TRUE(same_lists(points, sorted(lists), all_pairs(points, {.support = 0})));
}

TYPED_TEST(CellGridIn, TakesCloudsWithoutReceivers) {
  constexpr int D = TestFixture::D;
  auto points = random_cloud<D>();
  points.receivers = 0;
  for (const auto& cloud : {points, Points<D>{}}) {
    EXPECT_EQ(search(cloud, {.support = 2}).receivers(), 0);
    EXPECT_EQ(CellGrid<D>().order(cloud.position, 0, 1).size(), cloud.length.size());
  }
}

TYPED_TEST(CellGridIn, RefusesAdjacentPoints) {
  EXPECT_THROW(search(random_cloud<TestFixture::D>(), {.adjacent = 1}), std::invalid_argument);
}

TYPED_TEST(CellGridIn, ForgetsTheCloudItSearchedBefore) {
  constexpr int D = TestFixture::D;
  CellGridSearch<D> used;
  NeighbourLists lists;
  for (const auto& [name, points] : clouds_for_grids<D>()) {
    used.find(points, {.support = 2}, lists);
    EXPECT_TRUE(lists == search(points, {.support = 2})) << name;
  }
}

/// Points that `order` puts in order, of one length.
template <int D>
Points<D> ordered(const Points<D>& points, double reach) {
  CellGrid<D> grid;
  auto result = points;
  Index place = 0;
  for (const Index i : grid.order(points.position, points.receivers, reach)) {
    for (int d = 0; d < D; ++d) result.position[place * D + d] = points.position[i * D + d];
    ++place;
  }
  return result;
}

TYPED_TEST(CellGridIn, OrdersReceiversBeforeOthers) {
  constexpr int D = TestFixture::D;
  for (const auto& [name, points] : clouds_for_grids<D>()) {
    CellGrid<D> grid;
    const auto order = grid.order(points.position, points.receivers, 0.7);
    std::vector<Index> seen(order.begin(), order.end());
    EXPECT_TRUE(std::ranges::all_of(order.first(static_cast<std::size_t>(points.receivers)),
                                    [&](Index i) { return i < points.receivers; }));
    std::ranges::sort(seen);
    for (Index i = 0; i < points.size(); ++i) ASSERT_EQ(seen[i], i) << name;
  }
}

/// Points that are in order have lists in the order of numbers.
TYPED_TEST(CellGridIn, ListsOrderedPointsInOrder) {
  constexpr int D = TestFixture::D;
  for (const auto& [name, cloud] :
       {std::pair("plane", plane<D>()), std::pair("lattice", lattice<D>())}) {
    const double reach = 2 * cloud.length[0];
    const auto points = ordered(cloud, reach);
    NeighbourLists lists;
    CellGrid<D>().find(points.position, points.receivers, reach, {}, ListForm::any_order, lists);
    EXPECT_TRUE(lists == all_pairs(points, {.support = 2})) << name;
  }
}

/// The order depends on places, and on the points' ids where places agree in their cell.
TYPED_TEST(CellGridIn, OrderDoesNotDependOnTheOrderBefore) {
  constexpr int D = TestFixture::D;
  auto points = coincident_cloud<D>();
  points.receivers = points.size();
  std::iota(points.mass.begin(), points.mass.end(), 0);
  auto shuffled = points;
  shuffle(shuffled, 31);
  const auto ids_in_order = [](const Points<D>& cloud) {
    const std::vector<Index> id(cloud.mass.begin(), cloud.mass.end());
    CellGrid<D> grid;
    std::vector<Index> ids;
    for (const Index i : grid.order(cloud.position, cloud.receivers, 1, id)) ids.push_back(id[i]);
    return ids;
  };
  EXPECT_NE(points.position, shuffled.position);
  EXPECT_EQ(ids_in_order(points), ids_in_order(shuffled));
}

TYPED_TEST(CellGridIn, LeavesOutPairsOfIdlePoints) {
  constexpr int D = TestFixture::D;
  const auto points = plane<D>();
  const NeighbourRule rule{.support = 2};
  std::vector<std::uint8_t> idle(points.length.size());
  for (std::size_t i = 0; i < idle.size(); ++i) idle[i] = i % 3 == 0;
  NeighbourLists expected = all_pairs(points, rule), lists;
  const auto pairs = expected.pairs();
  expected.keep_if([&](Index i, Index j) { return !(idle[i] && idle[j]); });
  EXPECT_LT(expected.pairs(), pairs);
  CellGrid<D>().find(points.position, points.receivers, 2 * points.length[0], idle,
                     ListForm::any_order, lists);
  EXPECT_TRUE(sorted(lists) == expected);
}

/// Whatever the order of the points, and where the cells are folded; receivers that rest keep all
/// their neighbours.
TYPED_TEST(CellGridIn, ListsLaterNeighboursAlone) {
  constexpr int D = TestFixture::D;
  std::int64_t left_out = 0;
  for (const auto& [name, cloud] : clouds_for_grids<D>())
    for (const bool in_order : {false, true}) {
      const double reach = 2 * cloud.length[0];
      const auto points = in_order ? ordered(cloud, reach) : cloud;
      std::vector<std::uint8_t> idle(points.length.size());
      for (std::size_t i = 0; i < idle.size(); ++i) idle[i] = i % 3 == 0;
      NeighbourLists all, later;
      CellGrid<D> grid;
      grid.find(points.position, points.receivers, reach, idle, ListForm::ascending, all);
      EXPECT_TRUE(sorted(all) == all) << name;
      grid.find(points.position, points.receivers, reach, idle, ListForm::later, later);
      left_out += all.pairs() - later.pairs();
      all.keep_if([&](Index i, Index j) { return idle[i] || j > i; });
      EXPECT_TRUE(later == all) << name;
    }
  EXPECT_GT(left_out, 1000);
}

TYPED_TEST(CellGridIn, GivesTheSameAtAnyNumberOfThreads) {
  constexpr int D = TestFixture::D;
  const auto points = jittered_cloud<D>({.side = D == 1 ? 7000 : (D == 2 ? 83 : 19)});
  ASSERT_GT(points.receivers, parallel_from);
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(1);
  const NeighbourLists lists = search(points, {.support = 2});
  const auto position = ordered(points, 2).position;
  for (const int threads : {2, 4}) {
    omp_set_num_threads(threads);
    EXPECT_TRUE(lists == search(points, {.support = 2})) << threads << " threads";
    EXPECT_EQ(position, ordered(points, 2).position) << threads << " threads";
  }
  omp_set_num_threads(threads_before);
}

TYPED_TEST(CellGridIn, CheckNoticesADamagedList) {
  constexpr int D = TestFixture::D;
  const auto points = random_cloud<D>();
  const NeighbourRule rule{.support = 2};
  auto lists = copies_of(sorted(search(points, rule)));
  EXPECT_TRUE(same_lists(points, NeighbourLists(lists), all_pairs(points, rule)));
  lists[3].pop_back();
  EXPECT_FALSE(same_lists(points, NeighbourLists(lists), all_pairs(points, rule)));
}

}  // namespace
}  // namespace mote::test
