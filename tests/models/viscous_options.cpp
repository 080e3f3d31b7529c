// What the options of the viscous gas do, one by one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "mote/integrators/symplectic_euler.hpp"
#include "mote/integrators/velocity_verlet.hpp"
#include "mote/particles/failure.hpp"
#include "support/line_gas.hpp"

namespace mote::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

PressurelessGas viscous(const LineGas& gas, PressurelessGasOptions options, Index count = 41) {
  options.gravity = gas.gravity;
  return make_gas(gas, options, count, std::make_unique<CorrectedSph<1, Gauss<1>>>());
}

double total(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

TEST(SmoothedDensity, IsTheFivePointMeanOfTheStart) {
  const PressurelessGas rough = viscous(trapezoid(), {}),
                        smooth = viscous(trapezoid(), {.smoothed_density = true});
  const auto before = rough.cloud().values("density"), after = smooth.cloud().values("density");
  for (std::size_t i = 2; i + 2 < before.size(); ++i)
    EXPECT_NEAR(after[i],
                (before[i - 2] + before[i - 1] + before[i] + before[i + 1] + before[i + 2]) / 5,
                1e-15);
  EXPECT_NEAR(total(smooth.cloud().values("mass")), total(rough.cloud().values("mass")), 1e-14);
  EXPECT_THAT(smooth.remarks(), Contains(HasSubstr("(86)")));
  EXPECT_THAT(rough.remarks(), testing::Not(Contains(HasSubstr("(86)"))));
}

TEST(SmoothedDensity, RepeatsTheEndValuesBeyondTheEnds) {
  LineGas slope{"slope", 0, [](double x) { return 1 + x; }};
  const PressurelessGas gas = viscous(slope, {.smoothed_density = true}, 8);
  const double dx = 0.5, first = 1 + dx / 2;
  EXPECT_NEAR(gas.cloud().values("density")[0], first + (1 + 2) * dx / 5, 1e-15);
  EXPECT_NEAR(gas.cloud().values("density")[1], first + (0 + 0 + 1 + 2 + 3) * dx / 5, 1e-15);
}

/// The gas after one step of no viscosity but the artificial one.
Cloud after_artificial_step(LineEnds ends) {
  LineGas gas{"bend", 0, [](double x) { return 1 + x * x; }, [](double x) { return x * x; }, 5};
  gas.ends = ends;
  PressurelessGas model = viscous(gas, {.artificial_viscosity = 1e-3}, 10);
  model.begin_step(0, 0.01);
  model.end_step(0, 0.01);
  return model.cloud();
}

TEST(ArtificialViscosity, AddsMuTimesTheSecondDifference) {
  const Cloud gas = after_artificial_step(LineEnds::zero_gradient);
  const double dx = 0.5;
  for (Index i = 1; i < 7; ++i) {
    const double x = (i + 0.5) * dx;
    EXPECT_NEAR(gas.values("velocity")[i], x * x + 2e-3, 1e-14);
    EXPECT_NEAR(gas.values("density")[i], 1 + x * x + 2e-3, 1e-14);
  }
  // Zero gradient: what lies beyond the first cell is the first cell.
  EXPECT_NEAR(gas.values("velocity")[0], 0.0625 + 1e-3 / 0.25 * (0.5625 - 0.0625), 1e-14);
}

TEST(ArtificialViscosity, LeavesHeldEndsAndMirrorsVelocitiesAtWalls) {
  const Cloud held = after_artificial_step(LineEnds::held);
  EXPECT_EQ(held.values("velocity")[0], 0.0625);
  EXPECT_EQ(held.values("density")[0], 1.0625);
  const Cloud wall = after_artificial_step(LineEnds::wall);
  EXPECT_NEAR(wall.values("velocity")[0], 0.0625 + 4e-3 * (0.5625 - 3 * 0.0625), 1e-14);
}

TEST(ArtificialViscosity, IsCountedInTheReport) {
  PressurelessGas gas = viscous(trapezoid(), {.viscosity = 0.02, .artificial_viscosity = 5e-7});
  SymplecticEuler euler;
  run(gas, euler, 0.25, 1000);
  EXPECT_THAT(gas.remarks(), Contains(testing::AllOf(HasSubstr("in each of 1000 steps since"),
                                                     HasSubstr("kinematic viscosity of 0.002"),
                                                     HasSubstr("10 % of the model's own"))));
}

TEST(ArtificialViscosity, DoesNotGoWithDensityFromMasses) {
  EXPECT_THROW(viscous(trapezoid(),
                       {.density = DensityForm::mass_over_volume, .artificial_viscosity = 5e-7}),
               InputError);
}

// Without other forces the edges would fall freely, and never learn of what (82) does to
// velocities.
TEST(ArtificialViscosity, MovesTheEdgesOfCellsWithTheirParticles) {
  LineGas gas = flat_slope_flat();
  gas.ends = LineEnds::zero_gradient;
  PressurelessGas model = viscous(gas, {.artificial_viscosity = 5e-5});
  VelocityVerlet verlet;
  run(model, verlet, 1, 400);
  const auto x = model.cloud().position(), length = model.cloud().values("length");
  for (Index i = 1; i < 40; ++i) EXPECT_NEAR(length[i], (x[i + 1] - x[i - 1]) / 2, 1e-13);
}

TEST(ArtificialViscosity, WarnsBeyondHalfTheSquareOfTheShortestCell) {
  const double square = 4.0 / 41 * 4 / 41;
  for (const double part : {0.49, 0.51}) {
    PressurelessGas gas = viscous(trapezoid(), {.artificial_viscosity = part * square});
    const auto limits = gas.step_limits();
    const bool warns = limits.back().advisory && limits.back().step == 0;
    EXPECT_EQ(warns, part > 0.5);
  }
}

TEST(HeldEnds, KeepTheVelocityOfTheEndParticles) {
  for (const auto scheme :
       {ViscosityScheme::implicit, ViscosityScheme::substepped, ViscosityScheme::explicit_rates}) {
    PressurelessGas gas =
        viscous(flat_slope_flat(), {.viscosity = 0.5, .viscosity_scheme = scheme}, 21);
    VelocityVerlet verlet;
    run(gas, verlet, 0.5, 200);
    EXPECT_EQ(gas.cloud().values("velocity").front(), 0.5);
    EXPECT_EQ(gas.cloud().values("velocity").back(), -0.5);
    EXPECT_LT(gas.cloud().values("velocity")[1], 0.4999);
  }
}

TEST(ZeroGradientEnds, LetTheVelocityOfTheEndParticlesGo) {
  LineGas gas = flat_slope_flat();
  gas.ends = LineEnds::zero_gradient;
  PressurelessGas model = viscous(gas, {.viscosity = 0.5}, 21);
  VelocityVerlet verlet;
  run(model, verlet, 0.5, 200);
  EXPECT_LT(model.cloud().values("velocity").front(), 0.4999);
  EXPECT_NEAR(model.conserved()[1].value, 0, 1e-14);
}

/// A wave between walls, whose mirror images it is odd about.
LineGas between_walls() {
  return {"between_walls",
          0,
          [](double) { return 1.0; },
          [](double x) { return 0.3 * std::sin(std::numbers::pi * x); },
          1,
          LineEnds::wall};
}

TEST(Walls, KeepTheGasBetweenThem) {
  PressurelessGas gas = viscous(between_walls(), {.viscosity = 0.05}, 40);
  VelocityVerlet verlet;
  run(gas, verlet, 2, 400);
  gas.inspect();
  EXPECT_NEAR(total(gas.cloud().values("length")), 1, 1e-13);
  EXPECT_GT(gas.cloud().position().front(), 0);
  EXPECT_LT(gas.cloud().position().back(), 1);
  EXPECT_NEAR(gas.cloud().position()[39] + gas.cloud().values("length")[39] / 2, 1, 1e-3);
}

TEST(Walls, StopAParticleThatPassesThem) {
  PressurelessGas gas = viscous(between_walls(), {}, 10);
  gas.cloud().position()[9] = 1.5;
  EXPECT_THROW(gas.inspect(), NumericalFailure);
}

TEST(Walls, NeedAsManyParticlesAsTheyMirror) {
  EXPECT_THROW(viscous(between_walls(), {}, 3), InputError);
}

TEST(ExplicitViscosity, WarnsOnceItsLimitIsPassed) {
  const double limit = 4.0 / 41 * 4 / 41 / (2 * 0.5);
  for (const double part : {0.9, 1.1}) {
    PressurelessGas gas = make_gas(flat_slope_flat(),
                                   {.viscosity = 0.5,
                                    .frame = FrameChoice::lagrangian,
                                    .viscosity_scheme = ViscosityScheme::explicit_rates},
                                   41, std::make_unique<FiniteDifference<1>>());
    EXPECT_NEAR(gas.step_limits().back().step, limit, 1e-12);
    EXPECT_TRUE(gas.step_limits().back().advisory);
    gas.begin_step(0, part * limit);
    EXPECT_EQ(gas.warnings().size(), part > 1 ? 1 : 0);
  }
}

TEST(SubSteppedViscosity, CountsItsSubSteps) {
  PressurelessGas gas = viscous(
      flat_slope_flat(), {.viscosity = 0.5, .viscosity_scheme = ViscosityScheme::substepped});
  VelocityVerlet verlet;
  run(gas, verlet, 0.5, 10);
  EXPECT_THAT(gas.remarks(), Contains(HasSubstr("sub-steps in 10 steps")));
}

}  // namespace
}  // namespace mote::test
