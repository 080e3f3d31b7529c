#include "mote/integrators/velocity_verlet.hpp"

#include <gtest/gtest.h>

#include "mote/integrators/symplectic_euler.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr double a = 0.75, u = -1.5, g = 0.8125;

/// Position and velocity after this many steps of free fall from a with velocity u.
struct Fall {
  double position, velocity;
};
template <class Method>
Fall fall(int steps, double step) {
  FreeFall system({a}, {u}, {g});
  Method method;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  return {system.position[0], system.velocity[0]};
}

TEST(VelocityVerlet, IsExactToTheBitForConstantAcceleration) {
  constexpr double step = 1.0 / 64, time = 320 * step;  // numbers without rounding
  const Fall end = fall<VelocityVerlet>(320, step);
  EXPECT_EQ(end.position, a + u * time + g * time * time / 2);
  EXPECT_EQ(end.velocity, u + g * time);
}

TEST(VelocityVerlet, StaysExactOverManyStepsOfAnyLength) {
  constexpr double step = 1e-4, time = 30000 * step;
  const Fall end = fall<VelocityVerlet>(30000, step);
  const double position = a + u * time + g * time * time / 2;
  EXPECT_NEAR(end.position, position, 1e-14 * std::abs(position));
  EXPECT_NEAR(end.velocity, u + g * time, 1e-14 * std::abs(u + g * time));
}

TEST(VelocityVerlet, IsToldFromAMethodOfFirstOrderByConstantAcceleration) {
  constexpr double step = 1.0 / 64, time = 320 * step;
  EXPECT_NEAR(fall<SymplecticEuler>(320, step).position,
              a + u * time + g * time * (time + step) / 2, 1e-14);
}

}  // namespace
}  // namespace mote::test
