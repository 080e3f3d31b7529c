// What walls do to a weakly compressible flow.

#include <gtest/gtest.h>

#include "support/flow_case.hpp"

namespace mote::test {
namespace {

constexpr double spacing = 0.05;

FlowCase closed_box(double pressure) {
  FlowCase flow = flow_in_a_box(2, spacing, {0.6, 0.6});
  flow.pressure = [=](const Place&) { return pressure; };
  return with_walls(flow);
}

TEST(ClosedBox, KeepsFluidAtRest) {
  const auto flow = make_flow<2>(closed_box(3));
  run(*flow, 0.05, 100);
  EXPECT_LT(speed_of(*flow), 1e-12 * flow->parameters()["sound_speed"]);
  FlowCase disorder = closed_box(0);
  const auto disordered = make_flow<2>(in_disorder(disorder));
  run(*disordered, 0.05, 100);
  EXPECT_EQ(speed_of(*disordered), 0);
}

/// Negative control.
TEST(ClosedBox, DoesNotKeepDisorderUnderPressureAtRest) {
  FlowCase disorder = closed_box(3);
  const auto flow = make_flow<2>(in_disorder(disorder));
  run(*flow, 0.05, 100);
  EXPECT_GT(speed_of(*flow), 1e-3);
}

constexpr double fall = 2;  // gravity

FlowCase tank(double sound_speed) {
  FlowCase flow = flow_in_a_box(2, spacing, {1, 0.5});
  flow.options.sound_speed = sound_speed;
  flow.options.body_force.gravity = {0, -fall};
  flow.pressure = [](const Place& at) { return fall * (0.5 - at[1]); };
  with_wall(flow, 0, false);
  with_wall(flow, 0, true);
  with_wall(flow, 1, false);
  return flow;
}

/// Largest difference of the walls' pressure to that of the fluid at rest, carried on linearly; of
/// the walls' particles that see fluid.
double error_in_walls(const WeaklyCompressible<2>& flow, double gravity = fall) {
  double worst = 0;
  Index seeing = 0;
  for (Index i = 0; i < flow.cloud().count(); ++i) {
    const double pressure = flow.cloud().values("pressure")[i];
    if (is_fluid(flow, i) || pressure == 0) continue;
    const double y = vector_of(flow, "position", i)[1];
    worst = std::max(worst, std::abs(pressure - gravity * (0.5 - y)));
    ++seeing;
  }
  EXPECT_GT(seeing, 100);
  return worst;
}

/// A wall adds rho_j g.x of its neighbours where the line goes on with rho_0 g.x: the error is
/// within rho_0 g reach times the compression, p/(rho_0 c^2).
TEST(ExtrapolatedWalls, CarryTheHydrostaticPressureOn) {
  for (const double sound_speed : {20.0, 2e4, 2e6}) {
    const auto flow = make_flow<2>(tank(sound_speed));
    flow->complete_fields();
    const double compression = fall * 0.5 / (sound_speed * sound_speed);
    const double rounding = 1e-14 * sound_speed * sound_speed;  // of the density, in the pressure
    EXPECT_LT(error_in_walls(*flow), fall * 3 * spacing * compression + rounding);
    EXPECT_GT(error_in_walls(*flow, 1.1 * fall), 0.01);
  }
}

TEST(ExtrapolatedWalls, HoldATankAtRest) {
  FlowCase still = tank(20);
  still.options.viscosity = Viscosity::artificial;
  const auto flow = make_flow<2>(still);
  run(*flow, 0.2, 200);
  EXPECT_LT(speed_of(*flow), 0.02 * std::sqrt(fall * 0.5));
}

TEST(DynamicWalls, HoldATankForSomeSteps) {
  FlowCase still = tank(20);
  still.options.walls = WallForm::dynamic;
  still.options.viscosity = Viscosity::artificial;
  still.options.alpha = 0.1;
  const auto flow = make_flow<2>(still);
  run(*flow, 0.2, 200);
  EXPECT_LT(speed_of(*flow), 0.1 * std::sqrt(fall * 0.5));
  const double lowest =
      -most_in_fluid(*flow, [&](Index i) { return -vector_of(*flow, "position", i)[1] + 1; }) + 1;
  EXPECT_GT(lowest, 0);
}

/// The greatest change of density, relative to that at rest, that one short step brings to a wall.
double change_in_walls(const FlowCase& given) {
  const auto flow = make_flow<2>(given);
  run(*flow, 1e-9, 1);  // puts the particles in order
  const auto density = flow->cloud().values("density");
  const std::vector<double> before(density.begin(), density.end());
  run(*flow, 1e-6, 1);
  double most = 0;
  for (Index i = 0; i < flow->cloud().count(); ++i)
    if (!is_fluid(*flow, i))
      most = std::max(most, std::abs(density[i] / before[static_cast<std::size_t>(i)] - 1));
  return most;
}

/// A floor that fluid comes down on is compressed; one that continues the fluid has no density.
TEST(DynamicWalls, CarryTheirDensity) {
  FlowCase falling = closed_box(0);
  falling.velocity = [](const Place&) { return Triple{0, -1}; };
  EXPECT_EQ(change_in_walls(falling), 0);
  falling.options.walls = WallForm::dynamic;
  // The fluid's part of the divergence, about 1/(2 reach) of a speed of 1.
  EXPECT_GT(change_in_walls(falling), 1e-6);
  EXPECT_LT(change_in_walls(falling), 1e-5);
}

/// Antuono's correction leaves a density that falls linearly alone, in the floor too, which sees
/// lighter fluid only.
TEST(DynamicWalls, DoNotDiffuseALinearDensityWithItsCorrection) {
  FlowCase still = tank(20);
  still.options.equation_of_state = StateEquation::linear;
  still.options.walls = WallForm::dynamic;
  still.pressure = [](const Place& at) { return 10 - at[1]; };
  still.options.diffusion = DensityDiffusion::molteni;
  const double plain = change_in_walls(still);
  still.options.diffusion = DensityDiffusion::antuono;
  EXPECT_LT(change_in_walls(still), 0.3 * plain);
}

/// Negative control: the same without a floor.
TEST(DynamicWalls, DoNotHoldATankWithoutAFloor) {
  FlowCase open = tank(20);
  open.plan.walls.pop_back();
  open.options.walls = WallForm::dynamic;
  const auto flow = make_flow<2>(open);
  run(*flow, 0.2, 200);
  EXPECT_GT(speed_of(*flow), 0.1 * std::sqrt(fall * 0.5));
}

/// Shear between a bed at rest and a lid that drags with unit speed.
FlowCase couette(bool slips = false) {
  FlowCase flow = flow_in_a_box(2, spacing, {0.4, 1}, {true, false, false});
  flow.options.viscosity = Viscosity::morris;
  flow.options.kinematic_viscosity = 0.1;
  flow.options.free_surface = false;
  flow.velocity = [](const Place& at) { return Triple{at[1]}; };
  with_wall(flow, 1, false, {.slips = slips});
  with_wall(flow, 1, true,
            {.slips = slips, .velocity = [](double) { return Triple{1}; }, .travels = false});
  return flow;
}

/// Strongest acceleration, against nu U/spacing^2.
double strongest_pull(const FlowCase& given) {
  const auto flow = make_flow<2>(given);
  update_rates(*flow);
  const double pull =
      most_in_fluid(*flow, [&](Index i) { return acceleration_of(*flow, i).norm(); });
  return pull / (given.options.kinematic_viscosity / (spacing * spacing));
}

TEST(NoSlip, CarriesALinearVelocityOn) {
  EXPECT_LT(strongest_pull(couette()), 1e-13);
  // Negative controls: a profile that does not stand still at the bed, or bends.
  FlowCase sliding = couette();
  sliding.velocity = [](const Place& at) { return Triple{0.1 + 0.9 * at[1]}; };
  EXPECT_GT(strongest_pull(sliding), 1e-3);
  FlowCase bent = couette();
  bent.velocity = [](const Place& at) { return Triple{at[1] * at[1]}; };
  EXPECT_GT(strongest_pull(bent), 1e-3);
}

/// The rows of particles slide past each other by a spacing, and the profile stays. How far it
/// may go off is the error of the sums on rows in any position, some percent.
TEST(NoSlip, KeepsTheCouetteProfile) {
  const auto flow = make_flow<2>(couette());
  run(*flow, 1, 500);
  const double off = most_in_fluid(*flow, [&](Index i) {
    return std::abs(vector_of(*flow, "velocity", i)[0] - vector_of(*flow, "position", i)[1]);
  });
  EXPECT_LT(off, 0.03);
}

FlowCase sliding_along(bool slips) {
  FlowCase flow = couette(slips);
  flow.velocity = [](const Place&) { return Triple{1}; };
  return flow;
}

TEST(FreeSlip, ExertsNoShear) {
  EXPECT_LT(strongest_pull(sliding_along(true)), 1e-13);
  EXPECT_GT(strongest_pull(sliding_along(false)), 1e-2);
}

/// A slab of fluid that a piston pushes along x with unit acceleration, all of it at once.
FlowCase piston(const std::function<Triple(double)>& velocity) {
  FlowCase flow = flow_in_a_box(2, spacing, {1, 0.4}, {false, true, false});
  flow.plan.upper[0] = 3;
  flow.options.viscosity = Viscosity::artificial;
  flow.options.alpha = 0.1;
  flow.pressure = [](const Place& at) { return 1 - at[0]; };
  return with_wall(flow, 0, false, {.velocity = velocity});
}

double middle_of_fluid(const WeaklyCompressible<2>& flow) {
  double sum = 0;
  const auto fluid = fluid_of(flow);
  for (const Index i : fluid) sum += vector_of(flow, "position", i)[0];
  return sum / static_cast<double>(fluid.size());
}

/// Place of the wall's particle that was last in the list at the start.
double place_of_wall(const WeaklyCompressible<2>& flow) {
  const auto id = flow.cloud().values("id");
  const auto last = std::ranges::max_element(id) - id.begin();
  return flow.cloud().position()[static_cast<std::size_t>(last) * 2];
}

TEST(Piston, PushesTheFluidAsFarAsItGoes) {
  const auto flow = make_flow<2>(piston([](double t) { return Triple{t}; }));
  const double fluid = middle_of_fluid(*flow), wall = place_of_wall(*flow);
  run(*flow, 1, 700);
  EXPECT_NEAR(place_of_wall(*flow) - wall, 0.5, 1e-8);
  // The slab rides along as a whole, but for its compression, rho a L/(2 rho c^2) = 0.5 %.
  EXPECT_NEAR(middle_of_fluid(*flow) - fluid, 0.5, 0.01);
}

/// Negative control: a wall that drags and does not travel leaves the fluid where it is.
TEST(Piston, DoesNotPushWithoutTravelling) {
  FlowCase still = piston([](double t) { return Triple{t}; });
  still.plan.walls[0].body.travels = false;
  still.pressure = [](const Place&) { return 0; };
  const auto flow = make_flow<2>(still);
  const double wall = place_of_wall(*flow);
  run(*flow, 0.2, 140);
  EXPECT_EQ(place_of_wall(*flow), wall);
}

TEST(Piston, GoesItsWayToSecondOrder) {
  const auto error = [](int steps) {
    const auto flow = make_flow<2>(piston([](double t) { return Triple{std::sin(10 * t)}; }));
    const double start = place_of_wall(*flow);
    run(*flow, 0.25, steps);
    return std::abs(place_of_wall(*flow) - start - (1 - std::cos(2.5)) / 10);
  };
  const double coarse = error(50), fine = error(100);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << coarse << ", " << fine;
}

}  // namespace
}  // namespace mote::test
