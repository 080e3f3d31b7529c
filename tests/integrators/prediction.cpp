#include <gtest/gtest.h>

#include <cmath>

#include "mote/integrators/velocity_verlet.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr double end = 3;

/// Error of the damped oscillator at the end after this many steps.
template <class Method>
double error_after(int steps) {
  DampedOscillator system;
  Method method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  return system.error(end);
}

/// The order between 200 and 400 steps, which is 0.02 from the true one at most: the next term of
/// the error is about a step, 0.015, smaller.
template <class Method>
double observed_order() {
  return std::log2(error_after<Method>(200) / error_after<Method>(400));
}

/// Velocity Verlet that takes the velocities in the middle of the step for those at its end.
struct UnpredictedVerlet : Integrator {
  void advance_one_step(System& system, double time, double step) override {
    if (!system.rates_are_current()) {
      system.prepare(time);
      system.update_kick_rates(time);
    }
    kick(system, step / 2);
    system.update_drift_rates(time);
    drift(system, step);
    system.prepare(time + step);
    system.update_kick_rates(time + step);
    kick(system, step / 2);
  }
};

TEST(Prediction, GivesVelocityVerletOrderTwoWhereAccelerationsDependOnVelocities) {
  EXPECT_NEAR(observed_order<VelocityVerlet>(), 2, 0.05);
}

TEST(Prediction, IsWhatTheOrderComesFrom) {
  EXPECT_NEAR(observed_order<UnpredictedVerlet>(), 1, 0.05);
}

TEST(Prediction, TakesOneEvaluationAStep) {
  DampedOscillator system;
  VelocityVerlet method;
  for (int k = 0; k < 10; ++k) method.advance_one_step(system, 0.1 * k, 0.1);
  EXPECT_EQ(system.evaluations, 1 + 10);
}

}  // namespace
}  // namespace mote::test
