#include "mote/app/time_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

TEST(TimePlan, KeepsAStepThatDividesTheInterval) {
  const TimePlan plan(0.00025, 0.75, 7.5);
  EXPECT_EQ(plan.frames(), 10);
  EXPECT_EQ(plan.total_steps(), 30000);
  EXPECT_DOUBLE_EQ(plan.step_to(3), 0.00025);
  EXPECT_EQ(plan.time(10, 3000), 7.5);
}

TEST(TimePlan, ShortensAStepThatDoesNot) {
  const TimePlan plan(0.04, 0.3, 1.0);
  EXPECT_EQ(plan.frames(), 4);
  EXPECT_EQ(plan.steps_to(1), 8);
  EXPECT_DOUBLE_EQ(plan.step_to(1), 0.0375);
  EXPECT_EQ(plan.steps_to(4), 3);
  EXPECT_EQ(plan.total_steps(), 27);
  EXPECT_EQ(plan.time_of_frame(4), 1.0);
}

TEST(TimePlan, HasEqualFramesLateInALongRun) {
  const TimePlan plan(1e-4, 0.1, 5000);
  EXPECT_EQ(plan.total_steps(), 50'000'000);
  for (std::int64_t frame = 1; frame <= plan.frames(); ++frame)
    ASSERT_EQ(plan.steps_to(frame), 1000) << frame;
}

TEST(TimePlan, TakesOneStepWhereTheStepIsLongerThanTheRun) {
  const TimePlan plan(5, 0.5, 0.5);
  EXPECT_EQ(plan.total_steps(), 1);
  EXPECT_EQ(plan.step_to(1), 0.5);
}

constexpr double without_end = std::numeric_limits<double>::infinity();

/// The lengths of all steps from `start` to the end of a frame, where the state allows `longest`.
std::vector<double> lengths(const TimePlan& plan, std::int64_t frame, double longest) {
  std::vector<double> all;
  double time = plan.time_of_frame(frame - 1);
  while (time < plan.time_of_frame(frame) && all.size() < 100) {
    const Step step = plan.step_within(frame, time, longest);
    EXPECT_GT(step.end, time);
    all.push_back(step.length);
    time = step.end;
  }
  EXPECT_EQ(time, plan.time_of_frame(frame));
  return all;
}

TEST(StepWithin, HitsEveryFrameToTheBit) {
  const TimePlan plan(without_end, 0.3, 1.0);
  for (const double longest : {0.01, 0.0137, 0.07, 0.29999})
    for (std::int64_t frame = 1; frame <= plan.frames(); ++frame)
      for (const double length : lengths(plan, frame, longest)) {
        EXPECT_LE(length, longest);
        EXPECT_GE(length, 0.49 * std::min(longest, 0.1));
      }
}

TEST(StepWithin, HalvesTheRestRatherThanEndWithATinyStep) {
  const TimePlan plan(without_end, 1, 1);
  const auto all = lengths(plan, 1, 0.3);
  ASSERT_EQ(all.size(), 4);
  EXPECT_DOUBLE_EQ(all[0], 0.3);
  EXPECT_DOUBLE_EQ(all[1], 0.3);
  EXPECT_DOUBLE_EQ(all[2], 0.2);
  EXPECT_DOUBLE_EQ(all[3], 0.2);
}

TEST(StepWithin, IsNotLongerThanTheScenarioAllows) {
  const TimePlan plan(0.125, 1, 1);
  EXPECT_EQ(lengths(plan, 1, 0.5), std::vector<double>(8, 0.125));
}

TEST(StepWithin, GoesToTheFrameAtOnceWhereTheStateAllowsIt) {
  const TimePlan plan(without_end, 1, 4);
  EXPECT_EQ(lengths(plan, 3, 1), std::vector<double>{1});
  EXPECT_EQ(lengths(plan, 3, 50), std::vector<double>{1});
}

TEST(StepWithin, ThatIsNextToNothingIsAFailure) {
  const TimePlan plan(without_end, 1, 4);
  EXPECT_NO_THROW(plan.step_within(1, 0, 1.1e-9));
  for (const double longest : {0.9e-9, 0.0, -1.0, std::nan("")})
    EXPECT_THROW(plan.step_within(1, 0, longest), NumericalFailure) << longest;
}

TEST(TimePlan, KnowsWhenATenthOfTheWayIsPassed) {
  const TimePlan plan(without_end, 2, 4);
  EXPECT_TRUE(plan.passes_tenth(2, 2.15, 2.25));
  EXPECT_TRUE(plan.passes_tenth(2, 2.15, 2.95));
  EXPECT_FALSE(plan.passes_tenth(2, 2.21, 2.39));
}

}  // namespace
}  // namespace mote
