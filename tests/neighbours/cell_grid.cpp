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

}  // namespace
}  // namespace mote::test
