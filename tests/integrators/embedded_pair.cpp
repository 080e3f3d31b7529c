#include "mote/integrators/embedded_pair.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mote/integrators/all.hpp"
#include "mote/particles/failure.hpp"
#include "support/typed_lists.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double revolution = 2 * std::numbers::pi;

template <class Method>
struct EmbeddedPairs : testing::Test {};
using AllPairs = testing::Types<DormandPrince853, RungeKuttaNystrom86, RungeKuttaNystrom1210>;
TYPED_TEST_SUITE(EmbeddedPairs, AllPairs, NameOfType);

/// All values, in the order of parts.
std::vector<double> values_of(System& system) {
  std::vector<double> result;
  for (const auto parts : {system.drifted(), system.kicked()})
    for (const Evolving& part : parts)
      result.insert(result.end(), part.value.begin(), part.value.end());
  return result;
}

/// Goes from `time` to `end` and returns the number of steps.
int go_on(Integrator& method, System& system, double time, double end) {
  int steps = 0;
  for (; time < end; ++steps) time += method.advance(system, time, end - time);
  return steps;
}

template <class Method>
double error_with(double tolerance) {
  Planets planet(0.6);
  Method method;
  method.tolerate(tolerance);
  go_on(method, planet, 0, revolution);
  return planet.error(revolution);
}

TYPED_TEST(EmbeddedPairs, ErrInProportionToTheTolerance) {
  const double loose = error_with<TypeParam>(1e-7), tight = error_with<TypeParam>(1e-11);
  EXPECT_LT(loose, 1e-7);
  EXPECT_GT(tight, 1e-14);
  EXPECT_GT(loose / tight, 1e4 / 3);
  EXPECT_LT(loose / tight, 3 * 1e4);
}

TYPED_TEST(EmbeddedPairs, TryAgainWithAShorterStep) {
  Planets planet(0.6);
  TypeParam method;
  const double too_long[] = {1.0, 1e-4};
  method.recall(too_long);
  const double step = method.advance(planet, 0, unlimited);
  EXPECT_LT(step, 1);
  EXPECT_LT(planet.error(step), 10 * TypeParam::default_tolerance);
  Planets again(0.6);
  TypeParam once;
  once.advance_one_step(again, 0, step);
  EXPECT_EQ(values_of(planet), values_of(again));
  const int stages = again.evaluations;
  EXPECT_GT(planet.evaluations, stages);
  EXPECT_EQ((planet.evaluations - 1) % (stages - 1), 0);  // the rates at the start serve every try
}

TYPED_TEST(EmbeddedPairs, TakeLongerStepsWhereThePlanetIsSlow) {
  Planets planet(0.9);
  TypeParam method;
  double shortest = unlimited, longest = 0, time = 0;
  while (time < revolution) {
    const double step = method.advance(planet, time, unlimited);
    time += step;
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
  }
  EXPECT_GT(longest, 10 * shortest);
}

TYPED_TEST(EmbeddedPairs, KeepTheNextStepAfterOneThatWasCutShort) {
  Planets planet(0.6);
  TypeParam method;
  const double first = method.advance(planet, 0, unlimited);
  const auto memory = method.memory();
  EXPECT_EQ(method.advance(planet, first, 1e-3), 1e-3);
  EXPECT_EQ(method.memory(), memory);
  EXPECT_EQ(method.advance(planet, first + 1e-3, 1e-15), 1e-15);  // what rounding may leave over
  method.advance(planet, first + 1e-3, unlimited);
  EXPECT_NE(method.memory(), memory);
}

/// Values at the end of two runs, with a method of its own each.
template <class Method, class Handover>
std::vector<double> after_restart(Handover handover) {
  Planets planet(0.6);
  Method first, second;
  go_on(first, planet, 0, 2);
  handover(first, second);
  go_on(second, planet, 2, 4);
  return values_of(planet);
}

TYPED_TEST(EmbeddedPairs, GoOnToTheBitAfterARestart) {
  Planets planet(0.6);
  TypeParam method;
  go_on(method, planet, 0, 2);
  method.forget_rounding();
  go_on(method, planet, 2, 4);
  const auto uninterrupted = values_of(planet);
  const auto recalled =
      after_restart<TypeParam>([](auto& first, auto& second) { second.recall(first.memory()); });
  const auto forgotten = after_restart<TypeParam>([](auto&, auto&) {});
  EXPECT_EQ(recalled, uninterrupted);
  EXPECT_NE(forgotten, uninterrupted);
}

TYPED_TEST(EmbeddedPairs, HaveNoMemoryBeforeTheFirstStepAndCanForget) {
  TypeParam method;
  EXPECT_TRUE(method.memory().empty());
  Planets planet(0.6);
  const double first = method.advance(planet, 0, unlimited);
  method.recall({});
  EXPECT_TRUE(method.memory().empty());
  Planets another(0.6);
  EXPECT_EQ(method.advance(another, 0, unlimited), first);
}

TYPED_TEST(EmbeddedPairs, StartWithAStepThatDoesNotDependOnTheUnitOfTime) {
  Body slow = pendulum(0.25), fast = pendulum(64);
  const double longer = TypeParam().advance(slow, 0, unlimited);
  EXPECT_EQ(longer, 256 * TypeParam().advance(fast, 0, unlimited));
  EXPECT_GT(longer, 0.01 / 0.25);
  EXPECT_LT(longer, 1 / 0.25);
}

std::string failure_of(Integrator& method, System& system) {
  try {
    go_on(method, system, 0, 10);
  } catch (const NumericalFailure& failure) {
    return failure.what();
  }
  return "none";
}

/// From x = 1 it takes the time pi/sqrt(8).
TYPED_TEST(EmbeddedPairs, FailWhereAStoneFallsIntoTheSun) {
  Body stone(1, [](double place) { return -place / std::pow(std::abs(place), 3); });
  TypeParam method;
  EXPECT_THAT(failure_of(method, stone), testing::HasSubstr("no step that keeps to the tolerance"));
  EXPECT_NEAR(stone.last_time, std::numbers::pi / std::sqrt(8), 1e-8);
}

TYPED_TEST(EmbeddedPairs, FailWhereRatesAreNotFinite) {
  FreeFall body({1}, {0}, {std::nan("")});
  TypeParam method;
  EXPECT_THAT(failure_of(method, body), testing::HasSubstr("not finite"));
  EXPECT_THROW(method.advance_one_step(body, 0, 1), NumericalFailure);
}

TEST(NystromPairs, NeedAccelerationsWithoutVelocities) {
  DampedOscillator damped;
  Body body = pendulum();
  EXPECT_EQ(RungeKuttaNystrom86().missing_in(damped),
            "accelerations that depend on time and places alone");
  EXPECT_EQ(RungeKuttaNystrom1210().missing_in(body), "");
}

}  // namespace
}  // namespace mote::test
