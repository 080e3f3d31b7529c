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

/// Numbers of steps up to `end` whose errors are compared, `coarsest` and three times finer by
/// `ratio`; the error of the finest is to be `ceiling` step^order at most.
struct Ladder {
  int coarsest;
  double ratio, end, ceiling;

  int steps(int level) const {
    return static_cast<int>(std::lround(coarsest * std::pow(ratio, level)));
  }
};

/// Forward Euler's leading error is 2.5 step.
struct Oscillators {
  static ForcedOscillators start() { return ForcedOscillators(); }
  static constexpr Ladder low{60, 2, 3, 3}, high{8, 1.4, 3, 2e-3};
};

/// An equation that is not linear, for conditions of order that linear ones do not see; several
/// planets, so that no error vanishes by chance. Forward Euler's leading error is 16 step.
struct Orbits {
  static Planets start() { return Planets(0.15, 8); }
  static constexpr Ladder low{120, 2, 3, 20}, high{16, 1.4, 3, 1e-3};
};

/// A method whose errors do not lie between 1e-2 and 1e-13 on the ladder of its order has its own.
template <class Method, class Problem>
constexpr Ladder ladder = Method::order <= 4 ? Problem::low : Problem::high;
template <>
constexpr Ladder ladder<RungeKuttaNystrom86, Orbits>{16, 1.3, 3, 2e-5};
template <>
constexpr Ladder ladder<RungeKuttaNystrom1210, Oscillators>{9, 1.25, 12, 5e-10};
template <>
constexpr Ladder ladder<RungeKuttaNystrom1210, Orbits>{8, 1.25, 6, 5e-8};

/// Where a method is tested that these problems lack something for, or whose errors are those of
/// rounding on all of these ladders but their first rungs.
template <class Method>
constexpr std::string_view tested_in = "";
template <std::derived_from<ContEvol> Method>
constexpr std::string_view tested_in<Method> = "models/contevol.cpp";
template <>
constexpr std::string_view tested_in<BulirschStoer> = "integrators/bulirsch_stoer.cpp";
template <>
constexpr std::string_view tested_in<GaussRadau15> = "integrators/gauss_radau_15.cpp";
template <>
constexpr std::string_view tested_in<WisdomHolman> = "integrators/wisdom_holman.cpp";
template <>
constexpr std::string_view tested_in<Stoermer13> = "integrators/stoermer_13.cpp";
template <>
constexpr std::string_view tested_in<XIvas> = "integrators/x_ivas.cpp";

template <class Method>
constexpr int order_for_linear_equations = Method::order;
template <>
constexpr int order_for_linear_equations<RungeKutta8> = RungeKutta8::order_for_linear_equations;

/// Error at the end after this many steps.
template <class Method, class Problem>
double error_after(int steps) {
  constexpr double end = ladder<Method, Problem>.end;
  auto system = Problem::start();
  Method method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  return system.error(end);
}

/// Whether the observed order of each of three refinements is `order`, to 0.15 or a twenty-fifth,
/// and the error of the finest is below the ceiling.
template <class Method, class Problem>
testing::AssertionResult has_order(int order) {
  constexpr Ladder rungs = ladder<Method, Problem>;
  constexpr int finest = 3;
  double coarser = error_after<Method, Problem>(rungs.steps(0));
  for (int level = 1; level <= finest; ++level) {
    const double error = error_after<Method, Problem>(rungs.steps(level));
    const double refinement = static_cast<double>(rungs.steps(level)) / rungs.steps(level - 1);
    const double observed = std::log(coarser / error) / std::log(refinement);
    if (!(std::abs(observed - order) <= std::max(0.15, order / 25.0)))
      return testing::AssertionFailure() << "order " << observed << " at level " << level;
    coarser = error;
  }
  const double ceiling = rungs.ceiling * std::pow(rungs.end / rungs.steps(finest), order);
  if (coarser <= ceiling) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << coarser << ", ceiling " << ceiling;
}

/// Methods that these problems lack nothing for.
template <class Method>
struct IntegratorOrder : testing::Test {
  void SetUp() override {
    ForcedOscillators system;
    const std::string missing = Method().missing_in(system);
    if (missing.empty() && tested_in<Method>.empty()) return;
    ASSERT_FALSE(tested_in<Method>.empty()) << "it needs " << missing;
    GTEST_SKIP() << "tested in " << tested_in<Method>;
  }
};
TYPED_TEST_SUITE(IntegratorOrder, TypesOf<Integrators>::type, NameOfType);

TYPED_TEST(IntegratorOrder, IsObservedOnForcedOscillators) {
  constexpr int order = order_for_linear_equations<TypeParam>;
  EXPECT_TRUE((has_order<TypeParam, Oscillators>(order)));
}

TYPED_TEST(IntegratorOrder, IsObservedOnOrbits) {
  EXPECT_TRUE((has_order<TypeParam, Orbits>(TypeParam::order)));
}

TYPED_TEST(IntegratorOrder, CheckRejectsTheOrdersBesideIt) {
  constexpr int order = order_for_linear_equations<TypeParam>;
  EXPECT_FALSE((has_order<TypeParam, Oscillators>(order - 1)));
  EXPECT_FALSE((has_order<TypeParam, Oscillators>(order + 1)));
  EXPECT_FALSE((has_order<TypeParam, Orbits>(TypeParam::order - 1)));
  EXPECT_FALSE((has_order<TypeParam, Orbits>(TypeParam::order + 1)));
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
