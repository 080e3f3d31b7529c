#include "mote/neighbours/line.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <ostream>

#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace mote::test {
namespace {

NeighbourLists search(const Points<1>& points, const NeighbourRule& rule) {
  LineSearch search;
  NeighbourLists lists;
  search.find(points, rule, lists);
  return lists;
}

/// Distances of a receiver's neighbours, the least first.
std::vector<double> distances(const Points<1>& points, const NeighbourLists& lists, Index i) {
  std::vector<double> result;
  for (const Index j : lists[i])
    result.push_back(std::abs(points.position[i] - points.position[j]));
  std::ranges::sort(result);
  return result;
}

/// Whether both lists hold neighbours at the same distances.
testing::AssertionResult same_distances(const Points<1>& points, const NeighbourLists& found,
                                        const NeighbourLists& expected) {
  if (found.receivers() != points.receivers || expected.receivers() != points.receivers)
    return testing::AssertionFailure() << found.receivers() << " lists";
  for (Index i = 0; i < points.receivers; ++i)
    if (distances(points, found, i) != distances(points, expected, i))
      return testing::AssertionFailure() << "receiver " << i << " has " << found[i].size()
                                         << " neighbours, not " << expected[i].size();
  return testing::AssertionSuccess();
}

/// Whether every list runs from the lowest to the highest position, equal positions by number.
bool ascends(const Points<1>& points, const NeighbourLists& lists) {
  for (Index i = 0; i < lists.receivers(); ++i)
    if (!std::ranges::is_sorted(lists[i],
                                [&](Index a, Index b) { return stands_before(points, a, b); }))
      return false;
  return true;
}

struct Line {
  const char* name;
  Points<1> (*points)();

  friend void PrintTo(const Line& line, std::ostream* out) { *out << line.name; }
};

Points<1> random_line() {
  Draws draws(11);
  auto points = line_points(draws.uniform(200, -50, 50), draws.uniform(200, 0.2, 3));
  points.receivers = 150;
  return points;
}

Points<1> regular_line() {
  std::vector<double> position;
  for (int i = 0; i < 100; ++i) position.push_back(0.1 * i - 3);
  auto points = line_points(position, std::vector<double>(100, 0.1));
  shuffle(points, 12);
  points.receivers = 80;
  return points;
}

Points<1> clustered_line() {
  Draws draws(13);
  std::vector<double> position, length;
  for (const double spread : {1.0, 1e-3, 1e-9})
    for (int i = 0; i < 40; ++i) {
      position.push_back(spread * draws.uniform(0, 1) - 1 / spread);
      length.push_back(spread * draws.uniform(0.01, 0.1));
    }
  auto points = line_points(position, length);
  shuffle(points, 14);
  return points;
}

Points<1> coincident_line() {
  Draws draws(15);
  std::vector<double> position;
  for (int i = 0; i < 60; ++i) position.push_back(static_cast<double>(draws.below(10)));
  auto points = line_points(position, draws.uniform(60, 0.5, 1.5));
  points.receivers = 50;
  return points;
}

Points<1> single_point() { return line_points({2}); }

struct LineSearchOn : testing::TestWithParam<Line> {
  Points<1> points = GetParam().points();
};

TEST_P(LineSearchOn, FindsWhatTryingAllPairsFinds) {
  for (const PairLength length : {PairLength::mean, PairLength::scatter, PairLength::gather})
    for (const double reach : {0.5, 1.0, 2.0, 8.0, 1e6}) {
      const NeighbourRule rule{.support = 2, .smoothing_length = reach / 2, .length = length};
      const NeighbourLists lists = search(points, rule);
      EXPECT_TRUE(same_distances(points, lists, brute_force(points, rule))) << reach;
      EXPECT_TRUE(ascends(points, lists));
    }
}

TEST_P(LineSearchOn, FindsAdjacentPoints) {
  for (const Index adjacent : {1, 3}) {
    const NeighbourRule rule{.adjacent = adjacent};
    EXPECT_TRUE(search(points, rule) == brute_force(points, rule)) << adjacent;
  }
}

TEST_P(LineSearchOn, DoesNotDependOnTheNumbersOfPoints) {
  points.receivers = points.size();
  auto shuffled = points;
  shuffle(shuffled, 16);
  const NeighbourRule rule{.support = 1, .smoothing_length = 2};
  const NeighbourLists lists = search(points, rule), others = search(shuffled, rule);
  std::vector<std::vector<double>> before, after;
  for (Index i = 0; i < points.size(); ++i) {
    before.push_back(distances(points, lists, i));
    after.push_back(distances(shuffled, others, i));
  }
  std::ranges::sort(before);
  std::ranges::sort(after);
  EXPECT_EQ(before, after);
}

TEST_P(LineSearchOn, GivesTheSameListsAtAnyNumberOfThreads) {
  const int threads_before = omp_get_max_threads();
  const NeighbourRule rule{.support = 2, .smoothing_length = 1.5};
  omp_set_num_threads(1);
  const NeighbourLists lists = search(points, rule);
  for (const int threads : {2, 4}) {
    omp_set_num_threads(threads);
    EXPECT_TRUE(lists == search(points, rule)) << threads << " threads";
  }
  omp_set_num_threads(threads_before);
}

INSTANTIATE_TEST_SUITE_P(, LineSearchOn,
                         testing::Values(Line{"Random", random_line}, Line{"Regular", regular_line},
                                         Line{"Clustered", clustered_line},
                                         Line{"Coincident", coincident_line},
                                         Line{"SinglePoint", single_point}),
                         [](const auto& line) { return line.param.name; });

TEST(LineSearch, CountsANeighbourOnTheRim) {
  const auto points = regular_line();
  const NeighbourLists lists = search(points, {.support = 1, .smoothing_length = 3});
  for (Index i = 0; i < points.receivers; ++i) {
    const double x = points.position[i];
    if (x < -2.65 || x > 6.55) continue;
    EXPECT_EQ(lists[i].size(), 6) << "at " << x;
  }
}

TEST(LineSearch, ForgetsTheCloudItSearchedBefore) {
  LineSearch used;
  NeighbourLists lists;
  const NeighbourRule rule{.support = 1, .smoothing_length = 2};
  for (const auto& points : {random_line(), regular_line(), single_point(), coincident_line()}) {
    used.find(points, rule, lists);
    EXPECT_TRUE(lists == search(points, rule));
  }
}

TEST(LineSearch, CheckNoticesAMissingNeighbour) {
  const auto points = random_line();
  const NeighbourRule rule{.support = 2};
  auto lists = copies_of(search(points, rule));
  lists[0].pop_back();
  EXPECT_FALSE(same_distances(points, NeighbourLists(lists), brute_force(points, rule)));
  EXPECT_FALSE(same_distances(points, search(points, {.support = 2.1}), brute_force(points, rule)));
}

}  // namespace
}  // namespace mote::test
