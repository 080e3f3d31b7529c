#include "mote/particles/random.hpp"

#include <gtest/gtest.h>

namespace mote::test {
namespace {

/// The number in [0, 1) that 64 random bits stand for.
double number_of(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) / 9007199254740992.0;
}

// The first outputs of the authors' splitmix64.c for two seeds.
TEST(UniformRandom, IsSplitMix64) {
  EXPECT_EQ(uniform_random(0, 0), number_of(0xE220A8397B1DCDAF));
  EXPECT_EQ(uniform_random(0, 1), number_of(0x6E789E6AA1B965F4));
  EXPECT_EQ(uniform_random(0, 2), number_of(0x06C45D188009454F));
  EXPECT_EQ(uniform_random(1234567, 0), number_of(6457827717110365317u));
  EXPECT_EQ(uniform_random(1234567, 1), number_of(3203168211198807973u));
  EXPECT_EQ(uniform_random(1234567, 2), number_of(9817491932198370423u));
  EXPECT_EQ(uniform_random(1234567, 3), number_of(4593380528125082431u));
  EXPECT_EQ(uniform_random(1234567, 4), number_of(16408922859458223821u));
}

TEST(UniformRandom, FillsTheUnitIntervalEvenly) {
  constexpr int draws = 100'000;
  double sum = 0, squares = 0;
  for (int k = 0; k < draws; ++k) {
    const double u = uniform_random(42, static_cast<std::uint64_t>(k));
    ASSERT_TRUE(u >= 0 && u < 1);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / draws, 1.0 / 2, 0.004);  // four standard deviations
  EXPECT_NEAR(squares / draws, 1.0 / 3, 0.004);
}

}  // namespace
}  // namespace mote::test
