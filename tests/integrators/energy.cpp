#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mote/integrators/all.hpp"
#include "support/typed_lists.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr int steps_a_period = 10;
constexpr double period = 6.69997;  // of the pendulum, 4 K(sin(1/2))

/// The largest error of a pendulum's energy in so many more periods.
template <class Method>
double energy_error(Body& body, Method& method, int periods) {
  constexpr double step = period / steps_a_period;
  const auto energy = [](double angle, double velocity) {
    return velocity * velocity / 2 - std::cos(angle);
  };
  const double start = energy(1, 0);
  double worst = 0;
  for (int k = 0; k < steps_a_period * periods; ++k) {
    method.advance_one_step(body, 0, step);
    worst = std::max(worst, std::abs(energy(body.place(), body.velocity()) - start));
  }
  return worst;
}

/// Whether the energy's error is small in the first hundred periods, and never larger in 1e5.
template <class Method>
testing::AssertionResult keeps_energy() {
  Body body = pendulum();
  Method method;
  const double first = energy_error(body, method, 100);
  if (!(first < 0.3))
    return testing::AssertionFailure() << "an error of " << first << " in a hundred periods";
  for (int hundreds = 2; hundreds <= 1000; ++hundreds) {
    const double error = energy_error(body, method, 100);
    if (!(error <= 1.001 * first))
      return testing::AssertionFailure()
             << error << " after " << first << " in the hundred periods before " << 100 * hundreds;
  }
  return testing::AssertionSuccess();
}

template <class Method>
struct SymplecticIntegrator : testing::Test {};
using SymplecticIntegrators =
    testing::Types<SymplecticEuler, VelocityVerlet, LeapfrogKdk, LeapfrogDkd>;
TYPED_TEST_SUITE(SymplecticIntegrator, SymplecticIntegrators, NameOfType);

TYPED_TEST(SymplecticIntegrator, KeepsThePendulumsEnergyForAHundredThousandPeriods) {
  EXPECT_TRUE(keeps_energy<TypeParam>());
}

TEST(SymplecticIntegratorCheck, RejectsMethodsThatAreNotSymplectic) {
  EXPECT_FALSE(keeps_energy<ForwardEuler>());
  EXPECT_FALSE(keeps_energy<Heun>());
  EXPECT_FALSE(keeps_energy<RungeKutta4>());
  EXPECT_FALSE(keeps_energy<RungeKutta8>());
}

}  // namespace
}  // namespace mote::test
