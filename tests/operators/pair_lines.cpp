#include "mote/operators/terms/pair_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel_cases.hpp"

namespace mote::test {
namespace {

template <class Case>
struct KernelInLanes : testing::Test {
  const typename Case::Kernel kernel{};

  /// Places within the support and beyond it, and around the rim by a few roundings.
  std::vector<double> places() const {
    const double support = kernel.support();
    std::vector<double> places{0,
                               1e-300,
                               support,
                               std::nextafter(support, 0.0),
                               std::nextafter(support, 9.9),
                               support * rim_tolerance,
                               support * (1 + 3e-12),
                               1.5 * support,
                               40 * support};
    for (int k = 0; k < 63; ++k) places.push_back(support * k / 60.0);
    return places;
  }
};
TYPED_TEST_SUITE(KernelInLanes, KernelCases, KernelCaseName);

TYPED_TEST(KernelInLanes, IsTheKernelOfOneNumber) {
  const auto& kernel = this->kernel;
  const std::vector<double> places = this->places();
  ASSERT_EQ(places.size() % lane_count, 0);
  for (std::size_t k = 0; k < places.size(); k += lane_count) {
    const Lanes q(places.data() + k, std::experimental::element_aligned);
    const Lanes value = value_of(kernel, q), slope = slope_over_q_of(kernel, q);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const double scale = std::abs(kernel.slope_over_q(0.0));
      EXPECT_NEAR(value[lane], kernel.value(places[k + lane]), 1e-15 * kernel.value(0.0));
      EXPECT_NEAR(slope[lane], kernel.slope_over_q(places[k + lane]), 1e-15 * scale);
      const bool beyond = places[k + lane] > kernel.support() * rim_tolerance;
      EXPECT_TRUE(!beyond || (value[lane] == 0 && slope[lane] == 0)) << places[k + lane];
    }
  }
}

TEST(Transposed, TurnsLinesIntoLanes) {
  std::array<PairLine<3>, lane_count> lines;
  std::array<const double*, lane_count> rows;
  for (std::size_t k = 0; k < lane_count; ++k) {
    for (std::size_t c = 0; c < 8; ++c) lines[k].value[c] = static_cast<double>(10 * k + c);
    rows[k] = lines[k].value.data();
  }
  const LineLanes lanes = transposed(rows);
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t k = 0; k < lane_count; ++k)
      EXPECT_EQ(lanes[c][k], static_cast<double>(10 * k + c)) << k << ", " << c;
}

TEST(EightNeighbours, HaveTheReceiverInMissingPlaces) {
  std::vector<PairLine<2>> lines(12);
  for (std::size_t k = 0; k < lines.size(); ++k) lines[k].value[0] = static_cast<double>(k);
  std::vector<Index> neighbours{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  std::vector<double> met;
  std::vector<std::size_t> valid;
  for_each_eight<2>(lines, 11, neighbours,
                    [&](const LineLanes& lanes, const EightNeighbours& eight) {
                      for (std::size_t lane = 0; lane < lane_count; ++lane) {
                        met.push_back(lanes[0][lane]);
                        EXPECT_EQ(eight.number[lane], lanes[0][lane]);
                      }
                      valid.push_back(eight.valid);
                    });
  EXPECT_EQ(met, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 11, 11, 11, 11, 11}));
  EXPECT_EQ(valid, (std::vector<std::size_t>{8, 2}));
}

TEST(SumsOfEight, LoseWhatIsTakenFromThem) {
  std::vector<PairSums> sums(10);
  for (std::size_t j = 0; j < sums.size(); ++j) sums[j].value.fill(100.0 * static_cast<double>(j));
  std::array<Lanes, 4> lanes;
  for (std::size_t c = 0; c < 4; ++c)
    lanes[c] =
        Lanes([&](auto lane) { return 10.0 * static_cast<double>(lane) + static_cast<double>(c); });
  const std::array<Index, lane_count> numbers{3, 1, 7, 5, 9, 2, 3, 3};
  take_from(sums.data(), numbers.data(), lanes);
  for (std::size_t j = 0; j < sums.size(); ++j)
    for (std::size_t c = 0; c < 4; ++c) {
      double left = 100.0 * static_cast<double>(j);
      for (std::size_t k = 0; k < lane_count; ++k)
        if (static_cast<std::size_t>(numbers[k]) == j) left -= lanes[c][k];
      EXPECT_EQ(sums[j].value[c], left) << j << ", " << c;
    }
}

}  // namespace
}  // namespace mote::test
