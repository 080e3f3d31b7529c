#include "mote/sums/point_tree.hpp"

#include <gmock/gmock.h>
#include <omp.h>

#include <cmath>
#include <numeric>

#include "sums/clouds.hpp"

namespace mote::test {
namespace {

template <int D>
void expect_sound(const PointTree<D>& tree, const std::vector<double>& positions, Index capacity) {
  const auto count = static_cast<Index>(positions.size() / D);
  ASSERT_EQ(tree.count(), count);
  std::vector<Index> seen(tree.order().begin(), tree.order().end());
  std::ranges::sort(seen);
  for (Index i = 0; i < count; ++i) ASSERT_EQ(seen[static_cast<std::size_t>(i)], i);
  for (Index i = 0; i < count; ++i)
    for (std::size_t d = 0; d < D; ++d)
      ASSERT_EQ(
          tree.positions()[d][static_cast<std::size_t>(i)],
          positions[D * static_cast<std::size_t>(tree.order()[static_cast<std::size_t>(i)]) + d]);
  const auto nodes = static_cast<Index>(tree.nodes().size());
  ASSERT_EQ(tree.node(0).next, nodes);
  for (Index n = 0; n < nodes; ++n) {
    const auto& node = tree.node(n);
    double farthest = 0;
    for (Index i = node.points.begin; i < node.points.end; ++i) {
      Vec<D> place;
      for (std::size_t d = 0; d < D; ++d)
        place[d] = tree.positions()[d][static_cast<std::size_t>(i)];
      farthest = std::max(farthest, (place - node.centre).norm());
    }
    ASSERT_LE(farthest, node.radius * (1 + 1e-12) + 1e-15)
        << "node " << n;  // rounding
    if (tree.is_leaf(n)) {
      EXPECT_TRUE(node.points.count() <= capacity || farthest == 0) << node.points.count();
      continue;
    }
    Index begin = node.points.begin, children = 0;
    tree.for_each_child(n, [&](Index child) {
      EXPECT_EQ(tree.node(child).points.begin, begin);
      begin = tree.node(child).points.end;
      ++children;
    });
    EXPECT_EQ(begin, node.points.end);
    EXPECT_GE(children, 2);
  }
}

template <class T>
class Trees : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Trees, Dimensions);

TYPED_TEST(Trees, HoldEveryPointOnceInBallsOfAnyCloud) {
  constexpr int D = TypeParam::value;
  for (const auto& cloud : clouds<D>(20000)) {
    SCOPED_TRACE(cloud.name);
    PointTree<D> tree;
    tree.build(cloud.positions, 32);
    expect_sound(tree, cloud.positions, 32);
  }
}

TYPED_TEST(Trees, AreEmptyOrOneLeafForFewPoints) {
  constexpr int D = TypeParam::value;
  PointTree<D> tree;
  tree.build({}, 8);
  EXPECT_EQ(tree.count(), 0);
  EXPECT_TRUE(tree.nodes().empty());
  const std::vector<double> one(D, 0.3);
  tree.build(one, 8);
  ASSERT_EQ(tree.nodes().size(), 1u);
  EXPECT_GT(tree.node(0).radius, 0);
  EXPECT_LT(tree.node(0).radius, 1e-8);
  EXPECT_TRUE(tree.is_leaf(0));
}

TYPED_TEST(Trees, PutPointsOfOnePlaceIntoOneLeaf) {
  constexpr int D = TypeParam::value;
  const std::vector<double> same(D * 100, 0.7);
  PointTree<D> tree;
  tree.build(same, 8);
  ASSERT_EQ(tree.nodes().size(), 1u);
  EXPECT_GT(tree.node(0).radius, 0);
  EXPECT_LT(tree.node(0).radius, 1e-8);
}

TYPED_TEST(Trees, EndWhereNoNumberLiesBetween) {
  constexpr int D = TypeParam::value;
  std::vector<double> pairs(D * 40, 1);
  for (std::size_t i = 0; i < pairs.size(); i += 2 * D) pairs[i] = std::nextafter(1.0, 2);
  PointTree<D> tree;
  tree.build(pairs, 8);
  EXPECT_GE(tree.nodes().size(), 1u);
  EXPECT_EQ(tree.count(), 40);
}

TYPED_TEST(Trees, AreTheSameForAnyNumberOfThreads) {
  constexpr int D = TypeParam::value;
  const int threads = omp_get_max_threads();
  for (const auto& cloud : clouds<D>(50000)) {
    SCOPED_TRACE(cloud.name);
    PointTree<D> one, other;
    omp_set_num_threads(1);
    one.build(cloud.positions, 16);
    for (const int count : {2, 4}) {
      omp_set_num_threads(count);
      other.build(cloud.positions, 16);
      ASSERT_EQ(one.nodes().size(), other.nodes().size());
      EXPECT_TRUE(std::ranges::equal(one.order(), other.order()));
      for (std::size_t n = 0; n < one.nodes().size(); ++n) {
        ASSERT_EQ(one.nodes()[n].radius, other.nodes()[n].radius);
        ASSERT_EQ(one.nodes()[n].next, other.nodes()[n].next);
      }
    }
  }
  omp_set_num_threads(threads);
}

}  // namespace
}  // namespace mote::test
