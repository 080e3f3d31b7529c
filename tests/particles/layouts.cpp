#include "mote/particles/layouts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "support/agreement.hpp"

namespace mote::test {
namespace {

/// dx_i/alpha of one row of Table 2 of Isshiki (2014), as printed.
using Row = std::function<long double(int i, int N, long double L)>;

/// SplitMix64 by its own stream, one call after the other.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  long double next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z = z ^ (z >> 31);
    return std::ldexp(static_cast<long double>(z >> 11), -53);
  }

 private:
  std::uint64_t state_;
};

struct WideCells {
  std::vector<long double> centre, length;
};

/// The cells of a row on [lower, lower + L], alpha from sum dx_i = L and x_i from (57).
WideCells printed_cells(const Row& row, long double lower, long double L, int N) {
  WideCells cells;
  for (int i = 0; i < N; ++i) cells.length.push_back(row(i, N, L));
  const long double alpha = L / std::accumulate(cells.length.begin(), cells.length.end(), 0.0L);
  for (long double& dx : cells.length) dx *= alpha;
  for (int i = 0; i < N; ++i)
    cells.centre.push_back(i == 0
                               ? lower + cells.length[0] / 2
                               : cells.centre[i - 1] + (cells.length[i - 1] + cells.length[i]) / 2);
  return cells;
}

/// Whether a layout's cells are those of a row, for several lines and numbers of cells.
template <class Layout>
testing::AssertionResult is_row(const std::function<Row(std::uint64_t seed)>& row_of_seed) {
  for (const int N : {1, 2, 40, 41, 300})
    for (const std::uint64_t seed : {0, 99})
      for (const double lower : {0.0, -7.5}) {
        const Cells cells = cells_of_line<Layout>(lower, lower + 4, N, seed);
        const WideCells expected = printed_cells(row_of_seed(seed), lower, 4, N);
        if (auto right = agree(cells.length, expected.length, 1e-14); !right) return right;
        if (auto right = agree(cells.centre, expected.centre, 1e-14); !right) return right;
      }
  return testing::AssertionSuccess();
}

template <class Layout>
testing::AssertionResult is_row(const Row& row) {
  return is_row<Layout>([&](std::uint64_t) { return row; });
}

const Row regular = [](int, int N, long double L) { return L / N; };
const Row algebraic = [](int i, int N, long double L) { return L / N + i * L / 100; };
const Row geometric = [](int i, int N, long double L) { return L / N * std::pow(1.05L, i - 1); };
const Row sinusoidal = [](int i, int N, long double L) {
  return L / N * (1 + 0.5L * std::sin(4 * std::numbers::pi_v<long double> * i / N));
};

TEST(Layouts, RegularIsTheFirstRowOfTable2) { EXPECT_TRUE(is_row<Regular>(regular)); }
TEST(Layouts, AlgebraicIsTheSecondRowOfTable2) { EXPECT_TRUE(is_row<Algebraic>(algebraic)); }
TEST(Layouts, GeometricIsTheThirdRowOfTable2) { EXPECT_TRUE(is_row<Geometric>(geometric)); }
TEST(Layouts, SinusoidalIsTheFifthRowOfTable2) { EXPECT_TRUE(is_row<Sinusoidal>(sinusoidal)); }

TEST(Layouts, RandomIsTheFourthRowOfTable2) {
  EXPECT_TRUE(is_row<Random>([](std::uint64_t seed) -> Row {
    return [stream = SplitMix64(seed)](int, int N, long double L) mutable {
      return L / N * (1 + 0.0625L * stream.next());
    };
  }));
}

TEST(Layouts, ChecksTellRowsApart) {
  EXPECT_FALSE(is_row<Regular>(algebraic));
  EXPECT_FALSE(is_row<Sinusoidal>(regular));
  EXPECT_FALSE(is_row<Random>(regular));
  EXPECT_FALSE(is_row<Geometric>([](int i, int, long double) { return std::pow(1.0500001L, i); }));
}

template <class Layout>
void expect_cells_to_fill_the_line() {
  const Cells cells = cells_of_line<Layout>(-1, 3, 200, 5);
  double edge = -1;
  for (std::size_t i = 0; i < cells.centre.size(); ++i) {
    EXPECT_GT(cells.length[i], 0);
    EXPECT_NEAR(cells.centre[i], edge + cells.length[i] / 2, 1e-13) << Layout::name;
    edge += cells.length[i];
  }
  EXPECT_NEAR(edge, 3, 1e-13) << Layout::name;
}

TEST(Layouts, AllFillTheLineWithoutGaps) {
  for_each_type(Layouts{}, []<class Layout>() { expect_cells_to_fill_the_line<Layout>(); });
}

}  // namespace
}  // namespace mote::test
