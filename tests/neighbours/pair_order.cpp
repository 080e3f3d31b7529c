#include "mote/neighbours/pair_order.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "mote/neighbours/cell_grid.hpp"
#include "support/clouds.hpp"

namespace mote::test {
namespace {

constexpr double reach = 2.6;

/// Lists of later neighbours on a jittered lattice in the order of the grid; only the first
/// `receivers` have one.
NeighbourLists lists_of(Index side, Index receivers) {
  const auto cloud = jittered_cloud<3>({.side = side, .jitter = 0.1, .variation = 0});
  CellGrid<3> grid;
  std::vector<double> position;
  for (const Index i : grid.order(cloud.position, cloud.size(), reach))
    position.insert(position.end(), cloud.position.begin() + i * 3,
                    cloud.position.begin() + i * 3 + 3);
  NeighbourLists lists;
  grid.find(position, std::min(receivers, cloud.size()), reach, {}, ListForm::later, lists);
  return lists;
}

/// Pairs of blocks that have the same colour and reach the same receiver.
int collisions(const NeighbourLists& lists, Index points, Index block_size,
               std::span<const Index> colours) {
  std::vector<std::vector<Index>> met(static_cast<std::size_t>(points));  // blocks at every point
  const auto meet = [&](Index point, Index block) {
    auto& blocks = met[static_cast<std::size_t>(point)];
    if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
  };
  for (Index i = 0; i < lists.receivers(); ++i) {
    meet(i, i / block_size);
    for (const Index j : later_neighbours(lists, i))
      if (j < lists.receivers()) meet(j, i / block_size);
  }
  int found = 0;
  for (const auto& blocks : met)
    for (std::size_t a = 0; a < blocks.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        found += blocks[a] != blocks[b] && colours[static_cast<std::size_t>(blocks[a])] ==
                                               colours[static_cast<std::size_t>(blocks[b])];
  return found;
}

TEST(PairOrder, HasBlocksOfAColourThatReachNoReceiverTogether) {
  for (const auto& [side, receivers] :
       {std::pair(20, 8000), std::pair(20, 5000), std::pair(33, 99999)}) {
    const NeighbourLists lists = lists_of(side, receivers);
    const Index points = side * side * side;
    PairOrder order;
    order.arrange(lists);
    const auto colours = order.colours();
    EXPECT_EQ(collisions(lists, points, order.block_size(), colours), 0);
    // It is not done by giving each block a colour of its own: threads have something to share.
    EXPECT_LT(std::ranges::max(colours) + 1, static_cast<Index>(colours.size()) / 3);
    // Negative control.
    const std::vector<Index> one_colour(colours.size());
    EXPECT_GT(collisions(lists, points, order.block_size(), one_colour), 0);
  }
}

TEST(PairOrder, VisitsEveryReceiverOnceAtAnyNumberOfThreads) {
  const NeighbourLists lists = lists_of(33, 99999);
  PairOrder order;
  order.arrange(lists);
  const int threads_before = omp_get_max_threads();
  for (const int threads : {1, 4}) {
    omp_set_num_threads(threads);
    std::vector<int> visits(static_cast<std::size_t>(lists.receivers()));
    order.for_each_block([&](Index block, Index begin, Index end) {
      EXPECT_EQ(begin, block * order.block_size());
      for (Index i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
    });
    EXPECT_EQ(visits, std::vector<int>(visits.size(), 1)) << threads << " threads";
  }
  omp_set_num_threads(threads_before);
}

/// Where everybody reaches everybody, blocks come one after the other.
TEST(PairOrder, GivesEveryBlockItsColourWhereAllMeet) {
  constexpr Index receivers = 100 * 128;
  std::vector<std::vector<Index>> lists(receivers, {receivers - 1});
  PairOrder order;
  order.arrange(NeighbourLists(lists));
  std::vector<Index> colours(order.colours().begin(), order.colours().end());
  std::ranges::sort(colours);
  ASSERT_EQ(colours.size(), 100);
  for (Index k = 0; k < 100; ++k) EXPECT_EQ(colours[static_cast<std::size_t>(k)], k);
}

TEST(PairOrder, TakesNobodyAndLonelyPoints) {
  PairOrder order;
  for (const std::size_t receivers : {0, 1, 1000}) {
    order.arrange(NeighbourLists(std::vector<std::vector<Index>>(receivers)));
    std::size_t visited = 0;
    order.for_each_block(
        [&](Index, Index begin, Index end) { visited += static_cast<std::size_t>(end - begin); });
    EXPECT_EQ(visited, receivers);
  }
}

TEST(LaterNeighbours, AreThoseOfHigherNumbers) {
  const NeighbourLists lists({{1, 2}, {0, 2, 3}, {0, 1}, {}});
  const auto later = [&](Index i) {
    const auto found = later_neighbours(lists, i);
    return std::vector<Index>(found.begin(), found.end());
  };
  EXPECT_EQ(later(0), (std::vector<Index>{1, 2}));
  EXPECT_EQ(later(1), (std::vector<Index>{2, 3}));
  EXPECT_TRUE(later(2).empty());
  EXPECT_TRUE(later(3).empty());
}

}  // namespace
}  // namespace mote::test
