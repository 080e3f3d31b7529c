#include "mote/neighbours/search.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "clouds.hpp"
#include "support/dimensions.hpp"

namespace mote::test {
namespace {

template <class Dimension>
struct SearchIn : testing::Test {
  static constexpr int D = Dimension::value;
};

TYPED_TEST_SUITE(SearchIn, Dimensions, NameOfDimension);

TYPED_TEST(SearchIn, FindsTheSameByEveryName) {
  constexpr int D = TestFixture::D;
  ASSERT_EQ(search_names<D>().size(), D == 1 ? 3 : 2);
  const NeighbourRule rule{.support = 1.5};
  for (const auto& choice : search_names<D>())
    for (const auto& [name, points] : clouds<D>()) {
      NeighbourLists lists;
      make_search<D>(choice.name)->find(points, rule, lists);
      auto sorted = copies_of(lists);
      for (auto& list : sorted) std::ranges::sort(list);
      EXPECT_TRUE(same_lists(points, NeighbourLists(sorted), all_pairs(points, rule)))
          << choice.name << ", " << name;
    }
}

TYPED_TEST(SearchIn, TakesNoPoints) {
  constexpr int D = TestFixture::D;
  for (const auto& choice : search_names<D>()) {
    NeighbourLists lists({{1, 2}});
    make_search<D>(choice.name)->find({}, {.support = 1}, lists);
    EXPECT_EQ(lists.receivers(), 0) << choice.name;
  }
}

TYPED_TEST(SearchIn, RefusesAnUnknownName) {
  constexpr int D = TestFixture::D;
  EXPECT_THROW(make_search<D>("cell_list"), std::invalid_argument);
  if constexpr (D > 1) {
    EXPECT_THROW(make_search<D>("line"), std::invalid_argument);
  }
}

TEST(NeighbourLists, AreCopiedAndMoved) {
  const std::vector<std::vector<Index>> rows = {{3, 1}, {}, {0, 1, 2}};
  NeighbourLists lists(rows), copy(lists);
  EXPECT_EQ(lists.pairs(), 5);
  lists.restart(1, 4);
  EXPECT_EQ(lists.pairs(), 0);
  const NeighbourLists moved(std::move(copy));
  EXPECT_EQ(copies_of(moved), rows);
  lists = moved;
  EXPECT_TRUE(lists == moved);
  EXPECT_FALSE(lists == NeighbourLists({{3, 1}, {}, {0, 2, 1}}));
}

}  // namespace
}  // namespace mote::test
