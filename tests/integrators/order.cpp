#include <gtest/gtest.h>

#include <cmath>

#include "mote/integrators/all.hpp"
#include "support/typed_lists.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr double end = 3;

/// Error of the oscillators at the end after this many steps.
template <class Method>
double error_after(int steps) {
  ForcedOscillators system;
  Method method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  return system.error(end);
}

/// Whether the observed order of each of three refinements is `order`, to 0.15, and the error of
/// the finest is at most 3 step^order. (Forward Euler's leading error here is 2.5 step.)
template <class Method>
testing::AssertionResult has_order(int order) {
  constexpr int coarsest = 60, levels = 4;
  double coarser = error_after<Method>(coarsest);
  for (int level = 1; level < levels; ++level) {
    const double error = error_after<Method>(coarsest << level);
    const double observed = std::log2(coarser / error);
    if (!(std::abs(observed - order) <= 0.15))
      return testing::AssertionFailure() << "order " << observed << " at level " << level;
    coarser = error;
  }
  const double ceiling = 3 * std::pow(end / (coarsest << (levels - 1)), order);
  if (coarser <= ceiling) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << coarser << ", ceiling " << ceiling;
}

template <class Method>
struct IntegratorOrder : testing::Test {};
TYPED_TEST_SUITE(IntegratorOrder, TypesOf<Integrators>::type, NameOfType);

TYPED_TEST(IntegratorOrder, IsObservedOnForcedOscillators) {
  EXPECT_TRUE(has_order<TypeParam>(TypeParam::order));
}

TYPED_TEST(IntegratorOrder, CheckRejectsTheOrdersBesideIt) {
  EXPECT_FALSE(has_order<TypeParam>(TypeParam::order - 1));
  EXPECT_FALSE(has_order<TypeParam>(TypeParam::order + 1));
}

/// Velocity Verlet whose second half kick takes the forces of the start of the step.
struct StaleVerlet : Integrator {
  void advance_one_step(System& system, double time, double step) override {
    system.prepare(time);
    system.update_kick_rates(time);
    kick(system, step / 2);
    system.update_drift_rates(time + step / 2);
    drift(system, step);
    kick(system, step / 2);
  }
};

/// Velocity Verlet that forgets that time goes on.
struct TimelessVerlet : Integrator {
  void advance_one_step(System& system, double, double step) override {
    right.advance_one_step(system, 0, step);
  }
  VelocityVerlet right;
};

/// Velocity Verlet over all but a ten-thousandth of the step: not consistent.
struct LazyVerlet : Integrator {
  void advance_one_step(System& system, double time, double step) override {
    right.advance_one_step(system, time, step * (1 - 1e-4));
  }
  VelocityVerlet right;
};

TEST(IntegratorOrderCheck, RejectsWrongMethods) {
  EXPECT_TRUE(has_order<VelocityVerlet>(2));
  EXPECT_FALSE(has_order<StaleVerlet>(2));
  EXPECT_FALSE(has_order<TimelessVerlet>(2));
  EXPECT_FALSE(has_order<LazyVerlet>(2));
}

}  // namespace
}  // namespace mote::test
