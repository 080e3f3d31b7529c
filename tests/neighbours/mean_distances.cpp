#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <numeric>
#include <type_traits>

#include "mote/neighbours/kd_tree.hpp"
#include "support/agreement.hpp"
#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace mote::test {
namespace {

/// The mean of the `count` smallest distances to other points, by trying all pairs.
template <int D>
std::vector<long double> means_of_all_pairs(const Points<D>& points, Index count) {
  std::vector<long double> means;
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<long double> distances;
    for (Index j = 0; j < points.size(); ++j)
      if (j != i) distances.push_back(wide_distance(points, i, j));
    std::ranges::sort(distances);
    distances.resize(std::min(distances.size(), static_cast<std::size_t>(count)));
    const long double sum = std::accumulate(distances.begin(), distances.end(), 0.0L);
    means.push_back(distances.empty() ? 0 : sum / distances.size());
  }
  return means;
}

template <int D>
Points<D> cloud() {
  return jittered_cloud<D>({.side = D == 1 ? 200 : (D == 2 ? 15 : 6), .jitter = 0.4, .seed = 3});
}

template <class Dimension>
struct MeanDistancesIn : testing::Test {
  static constexpr int D = Dimension::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MeanDistancesIn, Dimensions);

/// All points are asked, not only the receivers. A sum of `count` roots errs by a few roundings.
TYPED_TEST(MeanDistancesIn, AreThoseOfAllPairs) {
  constexpr int D = TestFixture::D;
  const auto points = cloud<D>();
  for (const Index count : {1, 2 * D, 20})
    EXPECT_TRUE(agree(KdTreeSearch<D>().mean_distances(points, count),
                      means_of_all_pairs(points, count), 1e-14));
}

TYPED_TEST(MeanDistancesIn, CountPointsAtTheSamePlace) {
  constexpr int D = TestFixture::D;
  auto points = cloud<D>();
  for (int d = 0; d < D; ++d) points.position[D + d] = points.position[d];
  const auto means = KdTreeSearch<D>().mean_distances(points, 3);
  EXPECT_TRUE(agree(means, means_of_all_pairs(points, 3), 1e-14));
  EXPECT_EQ(KdTreeSearch<D>().mean_distances(points, 1)[0], 0);
}

TYPED_TEST(MeanDistancesIn, AreOfAllOthersWhereThereAreFewer) {
  constexpr int D = TestFixture::D;
  Points<D> points;
  points.resize(3, 3);
  for (Index i = 0; i < 3; ++i) points.position[i * D] = i * i;
  EXPECT_EQ(KdTreeSearch<D>().mean_distances(points, 50), (std::vector<double>{2.5, 2, 3.5}));
  points.resize(1, 1);
  EXPECT_EQ(KdTreeSearch<D>().mean_distances(points, 2), std::vector<double>{0});
}

TYPED_TEST(MeanDistancesIn, AreTheSameAtAnyNumberOfThreads) {
  constexpr int D = TestFixture::D;
  const auto points = jittered_cloud<D>({.side = D == 1 ? 7000 : (D == 2 ? 83 : 19)});
  ASSERT_GT(points.size(), parallel_from);
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto means = KdTreeSearch<D>().mean_distances(points, 2 * D);
  for (const int threads : {2, 4}) {
    omp_set_num_threads(threads);
    EXPECT_EQ(KdTreeSearch<D>().mean_distances(points, 2 * D), means) << threads << " threads";
  }
  omp_set_num_threads(threads_before);
}

TYPED_TEST(MeanDistancesIn, CheckNoticesAnotherCount) {
  constexpr int D = TestFixture::D;
  const auto points = cloud<D>();
  EXPECT_FALSE(
      agree(KdTreeSearch<D>().mean_distances(points, 5), means_of_all_pairs(points, 4), 1e-3));
}

}  // namespace
}  // namespace mote::test
