// Incompressible water that nothing disturbs stays at rest, and what its readings say.

#include <gtest/gtest.h>

#include <map>

#include "support/incompressible_case.hpp"

namespace mote::test {
namespace {

constexpr double spacing = 0.05, depth = 0.5, gravity = 9.81, density = 1000;
constexpr double step = 0.014;  // 0.2 sqrt(spacing/gravity)

/// Water in an open tank.
IncompressibleCase open_tank() {
  auto flow = incompressible_box<2>(spacing, {0.5, depth});
  flow.options.body_force.gravity = {0, -gravity};
  flow.options.density = density;
  flow.options.tolerance = 1e-12;
  flow.options.source = PressureSource::divergence;
  with_wall(flow, 0, false);
  with_wall(flow, 0, true);
  return with_wall(flow, 1, false);
}

/// With a lid, so that there is no surface.
IncompressibleCase closed_tank() {
  auto flow = open_tank();
  return without_surface(with_wall(flow, 1, true), density * gravity * depth / 2);
}

/// What has come of water at rest after 20 steps: its highest speed in sqrt(gravity depth), and how
/// far p + rho gravity y is from its mean, in rho gravity depth.
struct Unrest {
  double speed, pressure;
};

Unrest unrest_of(const IncompressibleCase& given) {
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, 20, step);
  const auto head = [&](Index i) {
    const double height = vector_of(*flow, "position", i)[1] - depth / 2;
    return flow->cloud().values("pressure")[i] / (density * gravity * depth) + height / depth;
  };
  const auto fluid = fluid_of(*flow);
  double mean = 0;
  for (const Index i : fluid) mean += head(i) / static_cast<double>(fluid.size());
  const double pressure = most_in_fluid(*flow, [&](Index i) { return std::abs(head(i) - mean); });
  return {speed_of(*flow) / std::sqrt(gravity * depth), pressure};
}

/// As still as the pressure equation is solved.
void expect_stillness(const IncompressibleCase& flow, double tolerance = 1e-12) {
  const Unrest found = unrest_of(flow);
  EXPECT_LT(found.speed, tolerance);
  EXPECT_LT(found.pressure, tolerance);
}

/// The corrected operator is exact for the hydrostatic pressure, on disorder too; so is mps on a
/// lattice that walls go on with.
TEST(WaterAtRest, StaysSo) {
  expect_stillness(open_tank());
  expect_stillness(closed_tank());
  auto disorder = closed_tank();
  expect_stillness(in_disorder(disorder));
}

TEST(WaterAtRest, StaysSoByMpsOnALatticeBetweenWalls) {
  for (const auto gradient :
       {PressureGradient::plain, PressureGradient::repulsive, PressureGradient::symmetric}) {
    auto flow = closed_tank();
    flow.options.gradient = gradient;
    flow.options.source = PressureSource::mixed;
    expect_stillness(with_operator(flow, symmetric_mps<2>()));
  }
}

/// The speed that ripples of 0.01 m/s have after 0.84 s.
double speed_of_ripples(double viscosity) {
  auto flow = open_tank();
  flow.options.kinematic_viscosity = viscosity;
  flow.velocity = [](const Place& at) {
    return Triple{0.01 * std::sin(40 * at[0]) * std::cos(37 * at[1]), 0.01 * std::sin(43 * at[1])};
  };
  const auto made = make_incompressible<2>(flow);
  take_steps(*made, 60, step);
  return speed_of(*made);
}

/// Friction damps at a surface too, where the derivatives of a corrected operator look one way.
TEST(WaterThatRipples, IsCalmedByFriction) {
  EXPECT_LT(speed_of_ripples(1e-2), 1e-3);
  EXPECT_GT(speed_of_ripples(0), 3e-3);  // the negative control
}

/// How far the pressure after one step is from that of the depth, in that of the bed.
double error_of_pressure(const IncompressibleCase& given) {
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, 1, step);
  const double error = most_in_fluid(*flow, [&](Index i) {
    const double below = depth - vector_of(*flow, "position", i)[1];
    return std::abs(flow->cloud().values("pressure")[i] - density * gravity * below);
  });
  return error / (density * gravity * depth);
}

TEST(WaterAtRest, HasThePressureOfItsDepth) { EXPECT_LT(error_of_pressure(open_tank()), 1e-12); }

/// Mps errs where the lattice ends: by a fifth of a spacing where missing neighbours stand in for
/// the surface, and by more where the particles there are given their pressure.
TEST(WaterAtRest, HasNearlyThePressureOfItsDepthByMps) {
  auto flow = open_tank();
  with_operator(flow, symmetric_mps<2>());
  EXPECT_GT(error_of_pressure(flow), 0.2 * spacing / depth);  // the negative control
  flow.options.surface_test = SurfaceTest::missing_neighbours;
  EXPECT_LT(error_of_pressure(flow), 0.2 * spacing / depth);
}

TEST(WaterAtRest, StaysSoInThreeDimensions) {
  auto given = incompressible_box<3>(0.1, {0.8, 0.8, 0.5}, {true, true, false});
  given.options.body_force.gravity = {0, 0, -gravity};
  given.options.tolerance = 1e-12;
  given.options.source = PressureSource::divergence;
  const auto flow = make_incompressible<3>(with_wall(given, 2, false));
  take_steps(*flow, 10, step);
  EXPECT_LT(speed_of(*flow), 1e-12 * std::sqrt(gravity * depth));
}

/// Below the surface the kernel sees less than a lattice, which `mixed` fills up a little.
TEST(WaterAtRest, IsHardlyMovedByTheMixedSource) {
  auto flow = open_tank();
  flow.options.source = PressureSource::mixed;
  expect_stillness(flow, 1e-3);
  EXPECT_GT(unrest_of(flow).speed, 1e-6);
}

/// Negative controls: a tank that leans, gradients that are not 0 for a constant pressure on
/// disorder, and a start that moves.
TEST(WaterThatIsDisturbed, DoesNotRest) {
  auto leaning = open_tank();
  leaning.options.body_force.gravity[0] = 0.01 * gravity;
  EXPECT_GT(unrest_of(leaning).speed, 1e-3);
  auto repulsive = closed_tank();
  repulsive.options.gradient = PressureGradient::repulsive;
  EXPECT_GT(unrest_of(in_disorder(repulsive)).speed, 1e-2);
  auto turning = closed_tank();
  turning.velocity = [](const Place& at) { return Triple{0.01 * (at[1] - depth / 2)}; };
  EXPECT_GT(unrest_of(turning).speed, 1e-4);
}

std::map<std::string, double> readings_of(const Model& flow) {
  std::map<std::string, double> readings;
  for (const Reading& reading : flow.readings()) readings[reading.name] = reading.value;
  return readings;
}

TEST(Readings, TellHowThePressureWasSolvedFor) {
  auto given = open_tank();
  given.velocity = [](const Place& at) { return Triple{0.1 * at[0]}; };
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, 3, step);
  const auto readings = readings_of(*flow);
  EXPECT_GE(readings.at("iterations"), 1);
  EXPECT_GT(readings.at("residual"), 0);
  EXPECT_LE(readings.at("residual"), 1e-12);
  EXPECT_GT(readings.at("solver_share"), 0);
  EXPECT_LT(readings.at("solver_share"), 1);
  EXPECT_GT(readings.at("divergence"), 0);
  EXPECT_LT(readings.at("divergence"), 0.1);
  EXPECT_LT(std::abs(readings.at("volume_error")), 0.05);
  EXPECT_DOUBLE_EQ(readings.at("highest_speed"), speed_of(*flow));
}

TEST(Readings, AreFiniteBeforeTheFirstStepAndAfterIt) {
  const auto flow = make_incompressible<2>(closed_tank());
  for (int steps = 0; steps < 2; ++steps) {
    take_steps(*flow, steps, step);
    for (const auto& [name, value] : readings_of(*flow)) EXPECT_TRUE(std::isfinite(value)) << name;
  }
}

}  // namespace
}  // namespace mote::test
