// What single options of the incompressible fluid do, and the force on its walls.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "mote/solvers/linear_solver.hpp"
#include "support/agreement.hpp"
#include "support/incompressible_case.hpp"

namespace mote::test {
namespace {

constexpr double spacing = 0.05, gravity = 9.81, density = 1000;

/// Vortices in a box that is periodic along x, with walls along y if they are asked for.
IncompressibleCase vortices(bool walls) {
  auto flow = incompressible_box<2>(spacing, {1, 1}, {true, !walls, false});
  flow.options.source = PressureSource::divergence;
  flow.options.tolerance = 1e-12;
  flow.velocity = [](const Place& at) {
    const double k = 2 * std::numbers::pi;
    return Triple{std::sin(k * at[0]) * std::cos(k * at[1]),
                  -std::cos(k * at[0]) * std::sin(k * at[1])};
  };
  return without_surface(walls ? with_walls(flow) : flow);
}

double least_pressure(const IncompressibleCase& given) {
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, 1, 0.01);
  return std::ranges::min(flow->cloud().values("pressure"));
}

/// A square that turns as a whole: at its middle the pressure is far below that of its rim.
TEST(Tension, IsWhatLetsPressuresBeNegative) {
  auto flow = incompressible_box<2>(spacing, {1, 1});
  flow.options.source = PressureSource::divergence;
  flow.velocity = [](const Place& at) { return Triple{0.5 - at[1], at[0] - 0.5}; };
  EXPECT_LT(least_pressure(flow), -0.05);
  flow.options.tension = false;
  EXPECT_EQ(least_pressure(flow), 0);
}

std::vector<double> state_by(const std::string& solver, double tolerance) {
  auto given = vortices(true);
  given.options.solver = solver;
  given.options.tolerance = tolerance;
  const auto flow = make_incompressible<2>(in_disorder(given));
  take_steps(*flow, 10, 0.005);
  return state_by_id(*flow);
}

/// Every step adds an error of the tolerance, which ten steps make no more than a hundredfold.
TEST(Solvers, AgreeAsFarAsTheirTolerance) {
  const Choices names = solver_names();
  const auto expected = state_by(names.front().name, 1e-12);
  for (const auto& name : names) EXPECT_TRUE(agree(state_by(name.name, 1e-12), expected, 1e-10));
  EXPECT_FALSE(agree(state_by(names.front().name, 1e-3), expected, 1e-10));  // negative control
}

/// Water over a bed, periodic along x.
IncompressibleCase pond(double depth) {
  auto flow = incompressible_box<2>(spacing, {0.5, depth}, {true, false, false});
  flow.options.body_force.gravity = {0, -gravity};
  flow.options.density = density;
  flow.options.source = PressureSource::divergence;
  return with_wall(flow, 1, false);
}

Triple force_on_bed(double depth) {
  const auto flow = make_incompressible<2>(pond(depth));
  take_steps(*flow, 3, 0.005);
  return flow->force_on(1);
}

TEST(ForceOnTheBed, IsTheWeightOfTheWater) {
  const double weight = density * gravity * 0.5 * 0.5;
  const Triple force = force_on_bed(0.5);
  EXPECT_NEAR(force[1], -weight, 0.005 * weight);
  EXPECT_NEAR(force[0], 0, 1e-9 * weight);
  EXPECT_LT(std::abs(force_on_bed(0.4)[1]), 0.9 * weight);  // negative control
}

TEST(ForceOnTheBed, IsNoneBeforeTheFirstStep) {
  const auto flow = make_incompressible<2>(pond(0.5));
  EXPECT_EQ(flow->force_on(1)[1], 0);
}

double longest_step(const IncompressibleCase& flow, double courant) {
  return make_incompressible<2>(flow)->longest_step(0, courant);
}

TEST(LongestIncompressibleStep, IsThatOfSpeedGravityOrViscosity) {
  auto fast = incompressible_box<2>(spacing, {1, 1});
  EXPECT_EQ(longest_step(fast, 0.2), std::numeric_limits<double>::infinity());
  fast.velocity = [](const Place&) { return Triple{3, 4}; };
  EXPECT_DOUBLE_EQ(longest_step(fast, 0.2), 0.2 * spacing / 5);
  EXPECT_DOUBLE_EQ(longest_step(pond(0.5), 0.2), 0.2 * std::sqrt(spacing / gravity));
  fast.options.kinematic_viscosity = 10;
  const double length = 1.5 * spacing;
  EXPECT_DOUBLE_EQ(longest_step(fast, 0.2), 0.125 * length * length / 10);
}

}  // namespace
}  // namespace mote::test
