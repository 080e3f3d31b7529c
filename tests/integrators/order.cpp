#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include "mote/integrators/all.hpp"
#include "support/typed_lists.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr double end = 3;

/// Steps at whose ends errors are compared: `coarsest` and three times finer by `ratio`. A method
/// whose errors do not lie between 1e-2 and 1e-12 on the ladder of its order specialises this.
struct Ladder {
  int coarsest;
  double ratio;
  int steps(int level) const {
    return static_cast<int>(std::lround(coarsest * std::pow(ratio, level)));
  }
};
template <class Method>
constexpr Ladder ladder = Method::order <= 4 ? Ladder{60, 2} : Ladder{8, 1.4};

/// Where a method is tested that forced oscillators, or an orbit, cannot feed.
template <class Method>
constexpr std::string_view tested_in = "";
template <std::derived_from<ContEvol> Method>
constexpr std::string_view tested_in<Method> = "models/contevol.cpp";

template <class Method>
constexpr int order_for_linear_equations = Method::order;
template <>
constexpr int order_for_linear_equations<RungeKutta8> = RungeKutta8::order_for_linear_equations;

/// Error at the end after this many steps.
template <class Method, class Problem>
double error_after(int steps) {
  auto system = Problem::start();
  Method method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  return system.error(end);
}

/// Whether the observed order of each of three refinements is `order`, to 0.15 or a twentieth, and
/// the error of the finest is at most ceiling step^order.
template <class Method, class Problem>
testing::AssertionResult has_order(int order) {
  constexpr int finest = 3;
  const auto steps = [](int level) { return Problem::refinement * ladder<Method>.steps(level); };
  double coarser = error_after<Method, Problem>(steps(0));
  for (int level = 1; level <= finest; ++level) {
    const double error = error_after<Method, Problem>(steps(level));
    const double refinement = static_cast<double>(steps(level)) / steps(level - 1);
    const double observed = std::log(coarser / error) / std::log(refinement);
    if (!(std::abs(observed - order) <= std::max(0.15, order / 20.0)))
      return testing::AssertionFailure() << "order " << observed << " at level " << level;
    coarser = error;
  }
  const double ceiling = Problem::ceiling * std::pow(end / steps(finest), order);
  if (coarser <= ceiling) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << coarser << ", ceiling " << ceiling;
}

/// Forward Euler's leading error is 2.5 step.
struct Oscillators {
  static ForcedOscillators start() { return ForcedOscillators(); }
  static constexpr int refinement = 1;
  static constexpr double ceiling = 3;
};

/// An equation that is not linear, for conditions of order that linear ones do not see. Forward
/// Euler's leading error is 22 step.
struct Orbit {
  static KeplerOrbit start() { return KeplerOrbit(0.3); }
  static constexpr int refinement = 2;
  static constexpr double ceiling = 25;
};

/// Methods that forced oscillators and an orbit lack nothing for.
template <class Method>
struct IntegratorOrder : testing::Test {
  void SetUp() override {
    ForcedOscillators system;
    const std::string missing = Method().missing_in(system);
    if (missing.empty()) return;
    ASSERT_FALSE(tested_in<Method>.empty()) << "it needs " << missing;
    GTEST_SKIP() << "tested in " << tested_in<Method>;
  }
};
TYPED_TEST_SUITE(IntegratorOrder, TypesOf<Integrators>::type, NameOfType);

TYPED_TEST(IntegratorOrder, IsObservedOnForcedOscillators) {
  constexpr int order = order_for_linear_equations<TypeParam>;
  EXPECT_TRUE((has_order<TypeParam, Oscillators>(order)));
}

TYPED_TEST(IntegratorOrder, IsObservedOnAnOrbit) {
  EXPECT_TRUE((has_order<TypeParam, Orbit>(TypeParam::order)));
}

TYPED_TEST(IntegratorOrder, CheckRejectsTheOrdersBesideIt) {
  constexpr int order = order_for_linear_equations<TypeParam>;
  EXPECT_FALSE((has_order<TypeParam, Oscillators>(order - 1)));
  EXPECT_FALSE((has_order<TypeParam, Oscillators>(order + 1)));
  EXPECT_FALSE((has_order<TypeParam, Orbit>(TypeParam::order - 1)));
  EXPECT_FALSE((has_order<TypeParam, Orbit>(TypeParam::order + 1)));
}

/// Velocity Verlet whose second half kick takes the forces of the start of the step.
struct StaleVerlet : Integrator {
  static constexpr int order = 2;
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
  static constexpr int order = 2;
  void advance_one_step(System& system, double, double step) override {
    right.advance_one_step(system, 0, step);
  }
  VelocityVerlet right;
};

/// Velocity Verlet over all but a ten-thousandth of the step: not consistent.
struct LazyVerlet : Integrator {
  static constexpr int order = 2;
  void advance_one_step(System& system, double time, double step) override {
    right.advance_one_step(system, time, step * (1 - 1e-4));
  }
  VelocityVerlet right;
};

TEST(IntegratorOrderCheck, RejectsWrongMethods) {
  EXPECT_TRUE((has_order<VelocityVerlet, Oscillators>(2)));
  EXPECT_FALSE((has_order<StaleVerlet, Oscillators>(2)));
  EXPECT_FALSE((has_order<TimelessVerlet, Oscillators>(2)));
  EXPECT_FALSE((has_order<LazyVerlet, Oscillators>(2)));
}

}  // namespace
}  // namespace mote::test
