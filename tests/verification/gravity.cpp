// The three cases of Isshiki (2014), section 6.3.1, against the exact solution at t = 7.5.

#include <gtest/gtest.h>

#include "mote/exact/gravitating_sheets.hpp"
#include "mote/integrators/symplectic_euler.hpp"
#include "mote/integrators/velocity_verlet.hpp"
#include "support/line_gas.hpp"

namespace mote::test {
namespace {

constexpr double end = 7.5;
constexpr int steps = 30'000;  // of 0.00025

/// The exact solution that starts from the state of `gas`, with this gravity.
GravitatingSheets exact_from(const PressurelessGas& gas, double gravity) {
  const auto copy = [&](std::string_view field) {
    const auto values = gas.cloud().values(field);
    return std::vector<double>(values.begin(), values.end());
  };
  return GravitatingSheets({copy("position"), copy("velocity"), copy("length"), copy("length_rate"),
                            copy("mass"), 0, gravity});
}

/// Largest errors, relative to the largest exact value of the field.
struct Errors {
  double position, velocity, density;
};

Errors errors_of(const LineGas& gas, Integrator& integrator, double gravity) {
  PressurelessGas model = make_gas(gas, {.gravity = gravity}, 41);
  const GravitatingSheets exact = exact_from(model, gas.gravity);
  run(model, integrator, end, steps);
  const auto error = [&](const Column& column) {
    const auto values = model.cloud().values(column.name);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      worst = std::max(worst, std::abs(values[i] - column.values[i]));
      largest = std::max(largest, std::abs(column.values[i]));
    }
    return worst / largest;
  };
  const Table table = exact.of_particles(end);
  return {error(table[0]), error(table[1]), error(table[2])};
}

struct SelfGravity : testing::TestWithParam<LineGas> {};

TEST_P(SelfGravity, IsExactToRoundingWithVelocityVerlet) {
  VelocityVerlet verlet;
  const Errors found = errors_of(GetParam(), verlet, GetParam().gravity);
  EXPECT_LE(found.position, 1e-12);
  EXPECT_LE(found.velocity, 1e-12);
  EXPECT_LE(found.density, 1e-12);
}

TEST_P(SelfGravity, WrongByABillionthIsNoticed) {
  VelocityVerlet verlet;
  const Errors found = errors_of(GetParam(), verlet, GetParam().gravity * (1 + 1e-9));
  EXPECT_GT(found.position, 1e-12);
  EXPECT_GT(found.velocity, 1e-12);
  EXPECT_GT(found.density, 1e-12);
}

// The error is that of the method: half a step of the velocity, -g t step/2.
TEST_P(SelfGravity, HasTheErrorOfOneHalfStepWithSymplecticEuler) {
  SymplecticEuler euler;
  const Errors found = errors_of(GetParam(), euler, GetParam().gravity);
  EXPECT_LE(found.position, 2e-5);
  EXPECT_GT(found.position, 1e-6);
  EXPECT_LE(found.velocity, 1e-12);
  EXPECT_LE(found.density, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(, SelfGravity, testing::Values(trapezoid(), rectangle(), slab()),
                         [](const auto& gas) { return gas.param.name; });

}  // namespace
}  // namespace mote::test
