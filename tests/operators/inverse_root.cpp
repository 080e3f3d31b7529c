#include "mote/operators/differential/inverse_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.hpp"

namespace mote::test {
namespace {

/// The inverse root of eight numbers, with eight others in the other pack of the estimate.
InverseRoot inverse_root(const Lanes& x, const Lanes& others = 1) {
  return RootEstimates({x, others}).refined(0);
}

/// Eight numbers with exponents from `lowest` to below `highest`.
Lanes numbers_of_any_size(Draws& draws, int lowest, int highest) {
  const auto range = static_cast<std::size_t>(highest - lowest);
  return Lanes([&](auto) {
    return std::ldexp(draws.uniform(1, 2), lowest + static_cast<int>(draws.below(range)));
  });
}

/// Largest relative error of eight numbers that should be x^(-n/2).
double power_error(const Lanes& found, const Lanes& x, int n) {
  double error = 0;
  for (std::size_t k = 0; k < lane_count; ++k) {
    const long double root = 1 / std::sqrt(static_cast<long double>(x[k]));
    const long double power = n == 1 ? root : n == 2 ? root * root : root * root * root;
    error = std::max(error, std::abs(static_cast<double>(found[k] / power - 1)));
  }
  return error;
}

struct PowerErrors {
  double value = 0, square = 0, cube = 0;
};

PowerErrors largest_errors(int lowest, int highest) {
  Draws draws(3);
  PowerErrors error;
  for (int k = 0; k < 20000; ++k) {
    const Lanes x = numbers_of_any_size(draws, lowest, highest);
    const InverseRoot root = inverse_root(x);
    error.value = std::max(error.value, power_error(root.value(), x, 1));
    error.square = std::max(error.square, power_error(root.square(), x, 2));
    error.cube = std::max(error.cube, power_error(root.cube(), x, 3));
  }
  return error;
}

constexpr double epsilon = 0x1p-53;  ///< half a unit in the last place of 1

TEST(InverseRoots, AreRightToAFewUnitsOfRounding) {
  for (const auto& [lowest, highest] : {std::pair(-1, 1), {-126, 128}, {-680, 680}}) {
    const PowerErrors error = largest_errors(lowest, highest);
    EXPECT_LT(error.value, 3 * epsilon);
    EXPECT_LT(error.square, 4 * epsilon);
    EXPECT_LT(error.cube, 5 * epsilon);
    EXPECT_GT(error.cube, epsilon);
    RecordProperty("value", std::to_string(error.value / epsilon));
    RecordProperty("square", std::to_string(error.square / epsilon));
    RecordProperty("cube", std::to_string(error.cube / epsilon));
  }
}

TEST(InverseRoots, BeyondSinglePrecisionAreByDivisionAndRoot) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x :
       {0.0, 5e-324, 1e-310, 0x1p-1022, 1e-200, 1e-38, 4e38, 1e200, 0x1p1023, infinity}) {
    const InverseRoot root = inverse_root(x);
    const double inverse = x == 0 ? 0 : 1 / x;
    EXPECT_EQ(root.value()[3], std::sqrt(inverse)) << x;
    EXPECT_EQ(root.square()[3], inverse) << x;
    EXPECT_EQ(root.cube()[3], inverse * std::sqrt(inverse)) << x;
  }
}

TEST(InverseRoots, DoNotDependOnTheNumbersBesideThem) {
  Draws draws(4);
  for (int k = 0; k < 1000; ++k) {
    const Lanes x = numbers_of_any_size(draws, -140, 140);
    const InverseRoot root = inverse_root(x, numbers_of_any_size(draws, -140, 140));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const InverseRoot alone = inverse_root(Lanes(x[lane]), 0);
      EXPECT_EQ(root.value()[lane], alone.value()[lane]);
      EXPECT_EQ(root.square()[lane], alone.square()[lane]);
      EXPECT_EQ(root.cube()[lane], alone.cube()[lane]);
    }
  }
}

TEST(InverseRoots, AreTheSameInBothPacksAndAtTheEdgeOfSinglePrecision) {
  const double least = 0x1p-126, most = 0x1.fffffep127;
  for (const double x : {least, most, std::nextafter(least, 0.0), std::nextafter(least, 1.0),
                         std::nextafter(most, 0.0), std::nextafter(most, 1e300), 0x1.ffffffp127}) {
    const auto cube = [x](const Lanes& others, std::size_t pack) -> double {
      const Lanes own(x);
      const RootEstimates both(pack == 0 ? std::array{own, others} : std::array{others, own});
      return both.refined(pack).cube()[5];
    };
    for (const double other : {1.0, 0.0}) {
      EXPECT_EQ(cube(other, 0), cube(1, 0)) << x;
      EXPECT_EQ(cube(other, 1), cube(1, 0)) << x;
    }
    EXPECT_LT(power_error(cube(1, 0), x, 3), 5 * epsilon) << x;
  }
}

TEST(Fused, IsRoundedOnce) {
  Draws draws(5);
  int twice_rounded = 0;
  for (int k = 0; k < 1000; ++k) {
    const double a = draws.uniform(1, 2), b = draws.uniform(1, 2), c = -a * b;
    EXPECT_EQ(fused(a, b, c)[k % lane_count], std::fma(a, b, c));
    twice_rounded += a * b + c != std::fma(a, b, c) ? 1 : 0;
  }
  EXPECT_GT(twice_rounded, 900);
}

}  // namespace
}  // namespace mote::test
