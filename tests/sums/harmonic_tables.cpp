#include "mote/sums/harmonic_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mote/sums/harmonic_rotation.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

/// The largest deviation of block^T block from the identity: coefficients may be turned to and fro.
double deviation(const double* block, int inputs, int outputs) {
  double worst = 0;
  for (int i = 0; i < inputs; ++i)
    for (int j = 0; j < inputs; ++j) {
      double sum = i == j ? -1 : 0;
      for (int m = 0; m < outputs; ++m) sum += block[i * outputs + m] * block[j * outputs + m];
      worst = std::max(worst, std::abs(sum));
    }
  return worst;
}

TEST(HarmonicTables, ExchangesOfAxesAreOrthogonal) {
  for (int n = 0; n <= highest_degree; ++n) {
    const double* matrix = harmonic_tables().exchange(n);
    for (int number = 0; number < 4; ++number) {
      const ExchangeBlock block = exchange_block(n, number);
      ASSERT_EQ(block.inputs, block.outputs * block.inputs == 0 ? 0 : block.outputs);
      EXPECT_LE(deviation(matrix, block.inputs, block.outputs), 1e-15) << n << ' ' << number;
      matrix += block.inputs * block.outputs;
    }
  }
}

TEST(HarmonicTables, AnAlteredEntryIsNoticed) {
  const ExchangeBlock block = exchange_block(9, 1);
  const double* matrix = harmonic_tables().exchange(9) + 25;
  std::vector<double> altered(matrix, matrix + block.inputs * block.outputs);
  EXPECT_LE(deviation(altered.data(), block.inputs, block.outputs), 1e-15);
  altered[7] *= 1 + 1e-12;
  EXPECT_GT(deviation(altered.data(), block.inputs, block.outputs), 1e-14);
}

TEST(HarmonicRotation, TurnsThereAndBackToWhatWas) {
  Draws draws(4);
  AxisTurn turn;
  std::array<Lanes, 3> moved;
  for (Lanes& x : moved) x = Lanes([&](auto) { return draws.uniform(-1, 1); });
  moved[0][1] = moved[1][1] = moved[2][2] = 0;
  moved[0][3] = moved[1][3] = moved[2][3] = 0;
  turn.prepare(highest_degree, moved);
  for (int n = 0; n <= highest_degree; ++n) {
    std::vector<Lanes> in, turned(static_cast<std::size_t>(2 * n + 1)), back(turned.size(), 0);
    for (std::size_t i = 0; i < turned.size(); ++i)
      in.push_back(Lanes([&](auto) { return draws.uniform(-1, 1); }));
    turn_to_axis(n, turn, in.data(), turned.data());
    add_turned_from_axis(n, turn, 1, turned.data(), back.data());
    for (std::size_t i = 0; i < in.size(); ++i)
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        ASSERT_NEAR(back[i][lane], in[i][lane], 2e-14) << n << ' ' << i << ' ' << lane;
  }
}

TEST(HarmonicRotation, DisplacementsComeToLieAlongTheAxis) {
  AxisTurn turn;
  std::array<Lanes, 3> moved{Lanes(0.3), Lanes(-0.4), Lanes(1.2)};
  moved[0][5] = moved[1][5] = 0;
  turn.prepare(1, moved);
  // The harmonics of degree 1 in their order are z, x and y.
  const std::array<Lanes, 3> in{moved[2], moved[0], moved[1]};
  std::array<Lanes, 3> out;
  turn_to_axis(1, turn, in.data(), out.data());
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_NEAR(out[0][lane], turn.distance[lane], 1e-15);
    EXPECT_NEAR(out[1][lane], 0, 1e-15);
    EXPECT_NEAR(out[2][lane], 0, 1e-15);
  }
}

}  // namespace
}  // namespace mote::test
