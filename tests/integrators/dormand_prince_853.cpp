#include "mote/integrators/dormand_prince_853.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "systems.hpp"

namespace mote::test {
namespace {

std::vector<double> values_of(System& system) {
  std::vector<double> result;
  for (const auto parts : {system.drifted(), system.kicked()})
    for (const Evolving& part : parts)
      result.insert(result.end(), part.value.begin(), part.value.end());
  return result;
}

/// Error of the path after this part of a first step.
double error_on_path(double step, double part) {
  Planets planets(0.15, 8);
  DormandPrince853 method;
  method.advance_one_step(planets, 0, step);
  method.go_along_path(planets, part);
  return planets.error(part * step);
}

/// Of one step's error; a path of order p errs by step^(p + 1) in it.
double observed_power(double part) {
  return std::log2(error_on_path(0.4, part) / error_on_path(0.2, part));
}

TEST(DormandPrince853, HasAPathOfOrderSeven) {
  for (const double part : {0.1, 0.3, 0.5, 0.8}) {
    EXPECT_NEAR(observed_power(part), 8, 0.3) << part;
    EXPECT_LT(error_on_path(0.2, part), 1e-9) << part;
  }
  EXPECT_NEAR(observed_power(1), 9, 0.3);
}

TEST(DormandPrince853, GoesThroughTheEndsOfTheStepToTheBit) {
  Planets planets(0.3);
  const auto start = values_of(planets);
  DormandPrince853 method;
  method.advance_one_step(planets, 0, 0.3);
  const auto end = values_of(planets);
  method.go_along_path(planets, 0.25);
  EXPECT_NE(values_of(planets), end);
  method.go_along_path(planets, 0);
  EXPECT_EQ(values_of(planets), start);
  method.go_along_path(planets, 1);
  EXPECT_EQ(values_of(planets), end);
}

TEST(DormandPrince853, TakesFourEvaluationsForItsPathOnce) {
  Planets planets(0.3);
  DormandPrince853 method;
  method.advance_one_step(planets, 0, 0.3);
  EXPECT_EQ(planets.evaluations, 12);
  for (const double part : {0.1, 0.9, 0.5}) method.go_along_path(planets, part);
  EXPECT_EQ(planets.evaluations, 12 + 4);
}

TEST(DormandPrince853, GoesOnAsIfNobodyHadAskedForItsPath) {
  Planets asked(0.3), left_alone(0.3);
  DormandPrince853 one, other;
  for (double time = 0; time < 3;) {
    const double step = one.advance(asked, time, std::numeric_limits<double>::infinity());
    one.go_along_path(asked, 0.7);
    one.go_along_path(asked, 1);
    EXPECT_EQ(other.advance(left_alone, time, std::numeric_limits<double>::infinity()), step);
    time += step;
  }
  EXPECT_EQ(values_of(asked), values_of(left_alone));
}

}  // namespace
}  // namespace mote::test
