// Flows in closed form, recognised in the states that models start from.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flow_starts.hpp"
#include "mote/exact/poiseuille_start.hpp"
#include "mote/exact/standing_wave.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

double value(const FlowSolution& flow, std::size_t column, double x, double y, double time) {
  const double place[] = {x, y};
  return flow.at_places(place, 2, time)[column].values[0];
}

const auto everywhere = [](double, double) { return true; };

PlaneStart vortices(double width, double height) {
  PlaneStart plane(width, height, 0.25);
  plane.fill(everywhere).start.periodic = {true, true, false};
  return plane;
}

TEST(TaylorGreenStart, IsMeasuredInSignPhaseAndWaves) {
  PlaneStart plane = vortices(2, 4);
  const double k = 2 * pi;  // two waves across, four up
  plane.start.initial =
      velocities([&](double x, double y) { return -3 * std::cos(k * x) * std::sin(k * y); },
                 [&](double x, double y) { return 3 * std::sin(k * x) * std::cos(k * y); });
  const auto flow = taylor_green_from(plane.setup());
  const double decay = std::exp(-2 * 0.1 * k * k * 0.02);
  EXPECT_NEAR(value(*flow, 0, 0.1, 0.3, 0.02), -3 * decay * std::cos(0.1 * k) * std::sin(0.3 * k),
              1e-12);
  EXPECT_NEAR(value(*flow, 2, 0.1, 0.3, 0), -2 * 9 / 4.0 * (std::cos(0.2 * k) + std::cos(0.6 * k)),
              1e-11);
}

TEST(TaylorGreenStart, RefusesOtherStarts) {
  PlaneStart plane = vortices(1, 1);
  EXPECT_THAT(refusal(taylor_green_from, plane), HasSubstr("needs vortices"));
  const double k = 2 * pi;
  plane.start.initial =
      velocities([&](double x, double y) { return std::sin(k * x) * std::cos(k * y); },
                 [&](double x, double y) { return -1.01 * std::cos(k * x) * std::sin(k * y); });
  EXPECT_THAT(refusal(taylor_green_from, plane), HasSubstr("differs by 0.0099 of U"));
  plane.start.periodic = {true, false, false};
  EXPECT_THAT(refusal(taylor_green_from, plane), HasSubstr("periodic in x and y"));
  plane.parameters.erase("gravity_x");
  EXPECT_THAT(refusal(taylor_green_from, plane), HasSubstr("needs a model with a gravity_x"));
}

PlaneStart channel() {
  PlaneStart plane(1, 2, 0.25);
  plane.fill(everywhere).wall("bed", 0, 1).wall("lid", 2, -1);
  plane.start.periodic = {true, false, false};
  return plane;
}

TEST(PoiseuilleStart, IsMeasuredFromTheWallsSurfaces) {
  PlaneStart plane = channel();
  plane.parameters["gravity_x"] = 3;
  const auto flow = poiseuille_from(plane.setup());
  EXPECT_NEAR(value(*flow, 0, 0, 0.5, 1.5), 3 * poiseuille_start(0.5, 1.5, 2, 0.1), 1e-13);
}

TEST(PoiseuilleStart, RefusesOtherStarts) {
  PlaneStart plane = channel();
  EXPECT_THAT(refusal(poiseuille_from, plane), HasSubstr("needs a force"));
  plane.parameters["gravity_x"] = 3;
  plane.start.bodies[1].slips = true;
  EXPECT_THAT(refusal(poiseuille_from, plane), HasSubstr("'bed' does not"));
  plane.start.bodies[1] = {"bed", BodyKind::wall, false, [](double) { return Triple{1, 0, 0}; }};
  EXPECT_THAT(refusal(poiseuille_from, plane), HasSubstr("walls at rest"));
  plane = channel();
  plane.parameters["gravity_x"] = 3;
  plane.start.periodic = {};
  EXPECT_THAT(refusal(poiseuille_from, plane), HasSubstr("periodic along x"));
  plane.start.wall_places[2].normal = {1, 0, 0};
  EXPECT_THAT(refusal(poiseuille_from, plane), HasSubstr("face each other"));
}

TEST(CouetteStart, TakesTheVelocitiesOfTheWalls) {
  PlaneStart plane = channel();
  EXPECT_THAT(refusal(couette_from, plane), HasSubstr("needs a wall that moves"));
  plane.start.bodies[2].velocity = [](double) { return Triple{4, 0, 0}; };
  EXPECT_NEAR(value(*couette_from(plane.setup()), 0, 0, 0.5, 1e4), 1, 1e-12);
  plane.start.bodies[2].velocity = [](double t) { return Triple{t, 0, 0}; };
  EXPECT_THAT(refusal(couette_from, plane), HasSubstr("'lid' changes"));
}

TEST(HydrostaticStart, TakesTheTopOfTheFluid) {
  PlaneStart plane(2, 2, 0.25);
  plane.fill([](double, double y) { return y < 1.5; }).parameters["gravity_y"] = -10;
  EXPECT_NEAR(value(*hydrostatic_from(plane.setup()), 2, 1, 0.5, 7), 2 * 10, 1e-12);
  plane.parameters["gravity_x"] = 1;
  EXPECT_THAT(refusal(hydrostatic_from, plane), HasSubstr("gravity along one axis"));
}

TEST(StandingWaveStart, IsMeasuredFromItsVelocities) {
  PlaneStart plane(2, 2, 0.125);
  plane.fill([](double, double y) { return y < 1; }).parameters["gravity_y"] = -1;
  EXPECT_THAT(refusal(standing_wave_from, plane), HasSubstr("level and at rest"));
  const double k = pi;  // two half waves
  plane.start.initial =
      velocities([&](double x, double y) { return -0.02 * std::cosh(k * y) * std::sin(k * x); },
                 [&](double x, double y) { return 0.02 * std::sinh(k * y) * std::cos(k * x); });
  const auto flow = standing_wave_from(plane.setup());
  EXPECT_NEAR(value(*flow, 1, 0, 1, 0), 0.02 * std::sinh(k), 1e-12);
  plane.start.initial =
      velocities([](double, double) { return 0.1; }, [](double, double) { return 0; });
  EXPECT_THAT(refusal(standing_wave_from, plane), HasSubstr("crest at the left end"));
}

TEST(StandingWaveStart, IsMeasuredFromItsSurface) {
  PlaneStart plane(1, 2, 1.0 / 256);
  const auto surface = [](double x) { return 1 + 0.05 * std::cos(pi * x); };
  plane.fill([&](double x, double y) { return y < surface(x); }).parameters["gravity_y"] = -1;
  const auto flow = standing_wave_from(plane.setup());
  // A column's height is rounded to cells, within half a spacing of 0.002.
  const auto& wave = dynamic_cast<const StandingWave&>(*flow);
  EXPECT_NEAR(wave.elevation(0, 0), 0.05, 5e-4);
  EXPECT_NEAR(wave.frequency(), 1.7691, 1e-3);
}

TEST(EllipticalDropStart, IsMeasuredFromItsVelocitiesAndMoments) {
  PlaneStart plane(4, 4, 1.0 / 32);
  plane.fill([](double x, double y) { return std::hypot(x - 2, y - 2) < 1; });
  plane.start.initial = velocities([](double x, double) { return -5 * (x - 2); },
                                   [](double, double y) { return 5 * (y - 2); });
  EXPECT_THAT(refusal(drop_from, plane), HasSubstr("has no viscosity"));
  plane.parameters["viscosity"] = 0;
  const auto flow = drop_from(plane.setup());
  EXPECT_NEAR(value(*flow, 0, 3, 2, 0), -5, 1e-12);
  // A circle: p = rho A^2/2 (a^2 - r^2), with a to the share of cells that its edge cuts.
  EXPECT_NEAR(value(*flow, 2, 2, 2, 0), 2 * 25 / 2.0, 0.25);
}

TEST(FlowStart, RefusesModelsThatAreNoFluid) {
  PlaneStart plane = channel();
  plane.parameters = {};
  for (const auto make : {taylor_green_from, poiseuille_from, couette_from, hydrostatic_from,
                          standing_wave_from, drop_from})
    EXPECT_THAT(refusal(make, plane), HasSubstr("needs a model with a density"));
}

TEST(FlowEntries, AreInTheCatalogue) {
  const Catalogue catalogue = standard_catalogue();
  const ExactEntry& entry = entry_named(catalogue.exact_solutions, "taylor_green");
  EXPECT_FALSE(entry.make);
  EXPECT_TRUE(entry.make_flow);
}

}  // namespace
}  // namespace mote::test
