#include "mote/integrators/bulirsch_stoer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "kepler_problem.hpp"
#include "ladder.hpp"
#include "mote/particles/failure.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

/// Error after ten times round a circle, nearly, in this many steps of given length.
double error_on_circle(int steps) {
  constexpr double end = 60;
  KeplerProblem system(0);
  BulirschStoer method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  return system.position_error(end);
}

/// Orders of extrapolation in even powers are even: those beside 12 are 10 and 14.
TEST(BulirschStoer, HasOrderTwelveForStepsOfGivenLength) {
  const Ladder ladder{{60, 75, 92}, 0.9, 2e-11};
  EXPECT_TRUE(has_order(ladder, BulirschStoer::order, error_on_circle));
  EXPECT_FALSE(has_order(ladder, BulirschStoer::order - 2, error_on_circle));
  EXPECT_FALSE(has_order(ladder, BulirschStoer::order + 2, error_on_circle));
}

/// Error of the forced oscillators after 30 steps whose times are multiplied by `clock`.
double error_of_oscillators(double clock) {
  constexpr double end = 20;
  constexpr int steps = 30;
  ForcedOscillators system;
  BulirschStoer method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, clock * k * step, step);
  return system.error(end);
}

TEST(BulirschStoer, TakesForcesAtTheirTimes) {
  EXPECT_LE(error_of_oscillators(1), 1e-11);
  EXPECT_GT(error_of_oscillators(1 - 1e-6), 1e-8);
}

/// An orbit from pericentre until `until`, with steps of the method's own.
struct Revolution {
  double error = 0, path_error = 0, path_velocity_error = 0;
  int steps = 0, evaluations = 0;
};
Revolution revolution(double eccentricity, double tolerance) {
  KeplerProblem system(eccentricity);
  BulirschStoer method;
  method.tolerate(tolerance);
  Revolution result;
  for (double time = 0; time < period; ++result.steps) {
    const int before = system.evaluations;
    const double step = method.advance(system, time, period - time);
    result.evaluations += system.evaluations - before;
    for (const double part : {0.05, 0.3, 0.5, 0.8}) {
      method.go_along_path(system, part);
      const double at = time + part * step;
      result.path_error = std::max(result.path_error, system.position_error(at));
      result.path_velocity_error = std::max(result.path_velocity_error, system.velocity_error(at));
    }
    method.go_along_path(system, 1);
    time += step;
  }
  result.error = system.position_error(period);
  return result;
}

/// The conditions are hard: half a unit in the last place of the velocity at pericentre is 1.6e-13
/// a period later.
TEST(BulirschStoer, TakesTheKeplerProblemOnceRoundToRounding) {
  const Revolution eccentric = revolution(0.9, BulirschStoer::default_tolerance);
  EXPECT_LE(eccentric.error, 5e-13);
  EXPECT_LE(eccentric.evaluations, 2200);
  EXPECT_LE(eccentric.path_error, 5e-13);
  const Revolution round = revolution(0.05, BulirschStoer::default_tolerance);
  EXPECT_LE(round.error, 2e-13);
  EXPECT_LE(round.evaluations, 600);
}

TEST(BulirschStoer, FollowsTheTolerance) {
  double last_error = 1;
  int last_evaluations = 0;
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    const Revolution next = revolution(0.6, tolerance);
    EXPECT_LT(next.error, 50 * tolerance) << tolerance;
    EXPECT_GT(next.error, 1e-4 * tolerance) << tolerance;
    EXPECT_LT(next.error, 0.1 * last_error);
    EXPECT_GT(next.evaluations, last_evaluations);
    EXPECT_LT(next.path_error, 50 * tolerance) << tolerance;
    last_error = next.error;
    last_evaluations = next.evaluations;
  }
}

/// Errors along the path of one step of this length, from exact values.
template <class Error>
double path_error(int steps, Error error) {
  KeplerProblem system(0.05);
  BulirschStoer method;
  const double step = period / steps;
  method.advance_one_step(system, 0, step);
  double largest = 0;
  for (const double part : {0.1, 0.25, 0.6, 0.9}) {
    method.go_along_path(system, part);
    largest = std::max(largest, error(system, part * step));
  }
  return largest;
}

TEST(BulirschStoer, HasAPathOfTheOrderOfItsStep) {
  const Ladder path{{4, 5, 6, 7}, 0.7, 5e-12};
  const auto position = [](int steps) {
    return path_error(steps, [](auto& system, double at) { return system.position_error(at); });
  };
  const auto velocity = [](int steps) {
    return path_error(steps, [](auto& system, double at) { return system.velocity_error(at); });
  };
  EXPECT_TRUE(has_order(path, 13, position));
  EXPECT_FALSE(has_order(path, 11, position));
  EXPECT_TRUE(has_order({{4, 5, 6, 7}, 0.9, 1e-10}, 12, velocity));
}

TEST(BulirschStoer, HasAPathThroughBothEnds) {
  KeplerProblem system(0.5);
  const auto start = system.state();
  BulirschStoer method;
  method.advance(system, 0, period);
  const auto reached = system.state();
  method.go_along_path(system, 0.4);
  EXPECT_NE(system.state(), reached);
  method.go_along_path(system, 0);
  EXPECT_EQ(system.state(), start);
  method.go_along_path(system, 1);
  EXPECT_EQ(system.state(), reached);
}

TEST(BulirschStoer, GoesOnFromItsMemoryWithTheSameBits) {
  KeplerProblem system(0.5);
  BulirschStoer method, recalled, afresh;
  double time = 0;
  for (int k = 0; k < 5; ++k) time += method.advance(system, time, period);
  const auto kept = system.state();
  recalled.recall(method.memory());
  method.forget_rounding();
  const auto three_steps = [&](BulirschStoer& by) {
    system.put(kept);
    double now = time;
    for (int k = 0; k < 3; ++k) now += by.advance(system, now, period);
    auto state = system.state();
    state.push_back(now);
    return state;
  };
  const auto gone_on = three_steps(method);
  EXPECT_EQ(three_steps(recalled), gone_on);
  EXPECT_NE(three_steps(afresh), gone_on);  // so the comparison above can fail
  EXPECT_TRUE(BulirschStoer().memory().empty());
  EXPECT_THROW(method.recall(std::vector<double>{1, 2, 3}), InputError);
}

TEST(BulirschStoer, KeepsItsOwnIdeaOfAStepThatIsCutShort) {
  KeplerProblem system(0);
  BulirschStoer method;
  double time = 0;
  for (int k = 0; k < 4; ++k) time += method.advance(system, time, period);
  const auto idea = method.memory();
  EXPECT_EQ(method.advance(system, time, 1e-3), 1e-3);
  EXPECT_EQ(method.memory(), idea);
}

TEST(BulirschStoer, ChoosesAStepWhereNothingMovesOrIsMoved) {
  FreeFall system({0.0}, {0.0}, {0.0});
  BulirschStoer method;
  const double step = method.advance(system, 0, std::numeric_limits<double>::infinity());
  EXPECT_GT(step, 0);
  EXPECT_TRUE(std::isfinite(step));
  EXPECT_EQ(system.position[0], 0);
}

TEST(BulirschStoer, FailsAtACollision) {
  FreeFall system({1.0}, {0.0}, {std::nan("")});
  BulirschStoer method;
  EXPECT_THROW(method.advance(system, 1, 1), NumericalFailure);
}

TEST(BulirschStoer, SaysWhatItNeeds) {
  KeplerProblem falling(0);
  DampedOscillator damped;
  EXPECT_EQ(BulirschStoer().missing_in(falling), "");
  EXPECT_EQ(BulirschStoer().missing_in(damped),
            "accelerations that depend on time and places alone");
  EXPECT_THROW(BulirschStoer().tolerate(0), InputError);
}

}  // namespace
}  // namespace mote::test
