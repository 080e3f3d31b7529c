#include "mote/particles/compensated_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mote {
namespace {

/// A tenth is not a number of base 2: the sum of 1e6 of them is wrong by 1e-6 if it is a plain one.
TEST(CompensatedSum, KeepsWhatRoundingLoses) {
  CompensatedSum sum;
  double plain = 0;
  for (int n = 0; n < 1000000; ++n) {
    sum.add(0.1);
    plain += 0.1;
  }
  EXPECT_NEAR(sum.value(), 1e5, 1e-11);
  EXPECT_GT(std::abs(plain - 1e5), 1e-7);
}

TEST(CompensatedSum, KnowsWhatItLacks) {
  CompensatedSum sum(1);
  sum.add(0x1p-60);
  EXPECT_EQ(sum.value(), 1);
  EXPECT_EQ(sum.lacks(1), -0x1p-60);
  EXPECT_EQ(sum.lacks(3), 2);
}

}  // namespace
}  // namespace mote
