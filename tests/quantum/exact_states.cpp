#include "mote/quantum/exact_states.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mote::test {
namespace {

/// A potential and its exact states on an interval beyond which they are 0 to rounding.
struct Case {
  ExactStates states;
  double (*potential)(double);
  double from, to;
};

const Case cases[] = {{well_states(-0.5, 1.5), [](double) { return 0.0; }, -0.5, 1.5},
                      {oscillator_states(), [](double x) { return x * x; }, -12, 12},
                      {coulomb_states(), [](double r) { return -2 / r; }, 0, 400}};

TEST(ExactStates, SolveTheEquation) {
  for (const Case& c : cases)
    for (int state = 0; state < 4; ++state)
      for (const double part : {0.503, 0.51, 0.55}) {
        const double x = c.from + (c.to - c.from) * (c.from == 0 ? part / 50 : part), h = 1e-3;
        const auto psi = [&](double place) { return c.states.wave_function(state, place); };
        const double bend = (psi(x + h) - 2 * psi(x) + psi(x - h)) / (h * h);
        EXPECT_NEAR(-bend + c.potential(x) * psi(x), c.states.energy(state) * psi(x), 1e-4);
      }
}

TEST(ExactStates, AreNormalisedAndOrthogonal) {
  constexpr int points = 40000;
  for (const Case& c : cases)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) {
        double sum = 0;
        const double step = (c.to - c.from) / points;
        for (int k = 0; k < points; ++k) {
          const double x = c.from + (k + 0.5) * step;
          sum += step * c.states.wave_function(a, x) * c.states.wave_function(b, x);
        }
        EXPECT_NEAR(sum, a == b ? 1 : 0, 1e-5) << a << " and " << b;
      }
}

TEST(ExactStates, ArePositiveAtFirst) {
  for (int state = 0; state < 4; ++state) {
    EXPECT_GT(well_states(0, 1).wave_function(state, 0.01), 0);
    EXPECT_GT(oscillator_states().wave_function(state, -5), 0);
    EXPECT_GT(coulomb_states().wave_function(state, 0.01), 0);
  }
}

}  // namespace
}  // namespace mote::test
