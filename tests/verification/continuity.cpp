// The density by the continuity equation (73c) in time: the order that each integrator promises,
// for an equation whose rate depends on the value itself and on the places of the particles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "mote/integrators/all.hpp"
#include "support/line_gas.hpp"
#include "support/typed_lists.hpp"

namespace mote::test {
namespace {

PressurelessGas gas_with_a_wave() {
  const LineGas gas{"wave", 0.0015,
                    [](double x) { return 0.6 - 0.5 * std::cos(std::numbers::pi * x / 2); },
                    [](double x) { return 0.05 * std::sin(x); }};
  const PressurelessGasOptions options{.gravity = gas.gravity, .density = DensityForm::continuity};
  return make_gas(gas, options, 41);
}

/// The density at t = 3 after this many steps.
std::vector<double> density_after(int steps, Integrator& method) {
  PressurelessGas model = gas_with_a_wave();
  run(model, method, 3, steps);
  const auto density = model.cloud().values("density");
  return {density.begin(), density.end()};
}

/// Largest difference of the densities after this many steps from those with very short steps.
template <class Method>
double error_after(int steps) {
  static const std::vector<double> reference = [] {
    RungeKutta4 method;
    return density_after(3200, method);
  }();
  Method method;
  const auto density = density_after(steps, method);
  double worst = 0;
  for (std::size_t i = 0; i < density.size(); ++i)
    worst = std::max(worst, std::abs(density[i] - reference[i]));
  return worst;
}

/// Whether three halvings of the step each show this order, to 0.15, and the last error is at most
/// half of step^order.
template <class Method>
testing::AssertionResult has_order(int order) {
  double coarser = error_after<Method>(25);
  for (const int steps : {50, 100, 200}) {
    const double error = error_after<Method>(steps), observed = std::log2(coarser / error);
    if (!(std::abs(observed - order) <= 0.15))
      return testing::AssertionFailure() << "order " << observed << " at " << steps << " steps";
    coarser = error;
  }
  if (coarser <= 0.5 * std::pow(3.0 / 200, order)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << coarser;
}

/// Integrators that a gas lacks nothing for.
template <class Method>
struct DensityByContinuity : testing::Test {
  void SetUp() override {
    PressurelessGas model = gas_with_a_wave();
    const std::string missing = Method().missing_in(model);
    if (!missing.empty()) GTEST_SKIP() << "it needs " << missing;
  }
};
TYPED_TEST_SUITE(DensityByContinuity, TypesOf<Integrators>::type, NameOfType);

TYPED_TEST(DensityByContinuity, HasTheOrderOfTheIntegrator) {
  if (TypeParam::order <= 4)
    EXPECT_TRUE(has_order<TypeParam>(TypeParam::order));
  else  // 25 steps leave an error of rounding
    EXPECT_LT(error_after<TypeParam>(25), 1e-13);
}

TEST(DensityByContinuityCheck, HasMoreThanErrorsOfRoundingAtOrderFour) {
  EXPECT_GT(error_after<RungeKutta4>(25), 1e-10);
}

TYPED_TEST(DensityByContinuity, CheckRejectsTheOrderAbove) {
  EXPECT_FALSE(has_order<TypeParam>(TypeParam::order + 1));
}

}  // namespace
}  // namespace mote::test
