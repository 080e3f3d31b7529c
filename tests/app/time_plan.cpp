#include "mote/app/time_plan.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mote
