#include "mote/integrators/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mote/integrators/initial_step.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr int power = 8;

TEST(StepControl, KeepsToNineTenthsOfTheToleratedStep) {
  // After an error of 1 as the one before, and error = step^power.
  StepControl control(power);
  control.recall(1);
  EXPECT_DOUBLE_EQ(control.after_accepted(2, 1), 1.8);
  EXPECT_DOUBLE_EQ(control.after_rejected(2, std::pow(2, power)), 0.9);
}

TEST(StepControl, GrowsMoreSlowlyWhenErrorsGrow) {
  StepControl steady(power), growing(power);
  steady.recall(0.1);
  growing.recall(0.001);
  EXPECT_GT(steady.after_accepted(1, 0.1), 1.2 * growing.after_accepted(1, 0.1));
  EXPECT_EQ(growing.previous_error(), 0.1);
}

TEST(StepControl, ChangesStepsWithinBounds) {
  StepControl control(power);
  EXPECT_EQ(control.after_accepted(1, 0), 6);
  EXPECT_EQ(control.after_rejected(1, 1e30), 0.1);
  EXPECT_EQ(control.after_rejected(1, INFINITY), 0.1);
  EXPECT_EQ(control.after_rejected(1, NAN), 0.1);
}

TEST(InitialStep, LeavesTheValuesAlone) {
  Body body = pendulum();
  const double step = initial_step(body, 0, 1e-10, power);
  EXPECT_EQ(body.place(), 1);
  EXPECT_EQ(body.velocity(), 0);
  EXPECT_GT(step, 0.01);
  EXPECT_LT(step, 1);
}

TEST(InitialStep, FollowsTheTolerance) {
  Body body = pendulum();
  EXPECT_NEAR(initial_step(body, 0, 1e-4, power) / initial_step(body, 0, 1e-12, power), 10, 1e-12);
}

TEST(InitialStep, IsThereWhereAllValuesAreZero) {
  FreeFall body({0}, {0}, {1});
  const double step = initial_step(body, 0, 1e-10, power);
  EXPECT_GT(step, 0);
  EXPECT_LT(step, 1);
}

}  // namespace
}  // namespace mote::test
