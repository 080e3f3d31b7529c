// Probes on particles whose fields are known everywhere.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "mote/observe/observer.hpp"
#include "mote/observe/surroundings.hpp"
#include "mote/particles/failure.hpp"
#include "standing_particles.hpp"

namespace mote::test {
namespace {

using testing::HasSubstr;

double linear(const Triple& place) { return 3 - 2 * place[0] + 5 * place[1] + 7 * place[2]; }
double wavy(const Triple& place) { return std::sin(9 * place[0]) * std::cos(7 * place[1]); }

/// A unit box of water from the origin on a bed of three layers.
StandingParticles pool(int dimension, double spacing, double depth = 1) {
  StandingParticles model(dimension, spacing);
  model.fill({0, 0, 0}, dimension == 2 ? Triple{1, depth, 0} : Triple{1, 1, depth}, 0);
  model.fill({-3 * spacing, dimension == 2 ? -3 * spacing : 0, -3 * spacing},
             dimension == 2 ? Triple{1 + 3 * spacing, 0, 0} : Triple{1, 1, 0}, 1);
  model.settle(linear, wavy);
  return model;
}

Probe point(std::vector<double> at) {
  return {.name = "p", .type = "point", .at = std::move(at), .fields = {"pressure"}};
}

double only(const Model& model, const Probe& probe, const Triple& period = {}) {
  return Observer({probe}, period, model).readings(model).at(0).value;
}

TEST(PointProbe, IsExactForALinearFieldInsideOnTheSurfaceAndInCorners) {
  const StandingParticles plane = pool(2, 0.05);
  for (const auto& [x, y] : {std::array{0.513, 0.377}, {0.3, 1.0}, {0.0, 0.0}, {1.0, 1.02}})
    EXPECT_NEAR(only(plane, point({x, y})), linear({x, y, 0}), 1e-12) << x << ", " << y;
  const StandingParticles space = pool(3, 0.125);
  for (const auto& [x, y, z] : {std::array{0.513, 0.377, 0.61}, {0.0, 0.0, 1.0}})
    EXPECT_NEAR(only(space, point({x, y, z})), linear({x, y, z}), 1e-12) << x;
}

TEST(PointProbe, IsOfSecondOrderForOthers) {
  const auto error = [](double spacing) {
    StandingParticles model = pool(2, spacing);
    model.settle(wavy, wavy);
    return std::abs(only(model, point({0.43, 0.61})) - wavy({0.43, 0.61, 0}));
  };
  const double order = std::log2(error(0.02) / error(0.01));
  EXPECT_GT(order, 1.8);
  EXPECT_LT(order, 2.2);
}

TEST(PointProbe, SeesNothingBeyondThreeSpacings) {
  const StandingParticles model = pool(2, 0.05);
  EXPECT_TRUE(std::isnan(only(model, point({0.5, 1 + 3.1 * 0.05 - 0.025}))));
  EXPECT_FALSE(std::isnan(only(model, point({0.5, 1 + 2.9 * 0.05 - 0.025}))));
}

TEST(PointProbe, TakesTheMeanWhereTheSlopeIsUnknown) {
  StandingParticles model(2, 0.1);
  for (int i = 0; i < 10; ++i) model.add({0.1 * i, 0.5, 0}, 0);
  model.settle([](const Triple& place) { return place[0]; }, wavy);
  EXPECT_NEAR(only(model, point({0.4, 0.6})), 0.4, 1e-12);
  StandingParticles drop(2, 0.1);
  drop.add({0.5, 0.5, 0}, 0);
  drop.settle(linear, wavy);
  EXPECT_EQ(only(drop, point({0.4, 0.6})), linear({0.5, 0.5, 0}));
}

TEST(PointProbe, LooksAcrossPeriodicSides) {
  StandingParticles model = pool(2, 0.05);
  model.settle([](const Triple& place) { return std::cos(2 * std::numbers::pi * place[0]); }, wavy);
  const double across = only(model, point({0, 0.5}), {1, 0, 0});
  EXPECT_NEAR(across, only(model, point({0.5, 0.5})) * -1, 1e-12);
  EXPECT_GT(std::abs(across - only(model, point({0, 0.5}))), 1e-3);
}

TEST(LineProbe, GivesExtremesAndEveryPoint) {
  const StandingParticles model = pool(2, 0.05);
  const Probe line{.name = "mid",
                   .type = "line",
                   .from = {0.5, 0},
                   .to = {0.5, 2},
                   .points = 41,
                   .fields = {"pressure", "velocity_y"},
                   .all = true};
  const auto readings = Observer({line}, {}, model).readings(model);
  ASSERT_EQ(readings.size(), 2u * 43u);
  EXPECT_EQ(readings[0].name, "mid_pressure_min");
  EXPECT_NEAR(readings[0].value, 2, 1e-12);
  EXPECT_EQ(readings[1].name, "mid_pressure_max");
  EXPECT_NEAR(readings[1].value, 2 + 5 * 1.05, 1e-12);  // the last place that sees two rows
  EXPECT_EQ(readings[12].name, "mid_pressure_10");
  EXPECT_NEAR(readings[12].value, linear({0.5, 0.5, 0}), 1e-12);
  EXPECT_TRUE(std::isnan(readings[42].value));
  EXPECT_EQ(readings[43].name, "mid_velocity_y_min");
}

TEST(LineProbe, HasTheSameBitsForAnyNumberOfThreads) {
  const StandingParticles model = pool(2, 0.005);
  const Probe line{.name = "l",
                   .type = "line",
                   .from = {0.1, 0},
                   .to = {0.9, 1},
                   .points = 200,
                   .fields = {"velocity"},
                   .all = true};
  const auto values = [&](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    std::vector<double> values;
    for (const Reading& reading : Observer({line}, {}, model).readings(model))
      values.push_back(reading.value);
    omp_set_num_threads(before);
    return values;
  };
  EXPECT_EQ(values(1), values(4));
}

Probe gauge(std::vector<double> at) { return {.name = "g", .type = "gauge", .at = std::move(at)}; }

TEST(Gauge, FindsALevelSurface) {
  for (const double depth : {1.0, 0.5}) {
    EXPECT_NEAR(only(pool(2, 0.05, depth), gauge({0.5})), depth, 0.1 * 0.05) << depth;
    EXPECT_NEAR(only(pool(3, 0.125, depth), gauge({0.5, 0.5})), depth, 0.1 * 0.125) << depth;
  }
}

TEST(Gauge, FindsItBesideAWallToo) {
  StandingParticles model(2, 0.05);
  model.fill({0, 0, 0}, {1, 0.5, 0}, 0);
  model.fill({-0.15, -0.15, 0}, {0, 1, 0}, 1);
  model.settle(linear, wavy);
  EXPECT_NEAR(only(model, gauge({0.0})), 0.5, 0.1 * 0.05);
  EXPECT_NEAR(only(model, gauge({0.02})), 0.5, 0.1 * 0.05);
}

TEST(Gauge, IgnoresDropsAndDryGround) {
  StandingParticles model(2, 0.05);
  model.fill({0, 0, 0}, {1, 0.5, 0}, 0);
  model.add({0.5, 0.9, 0}, 0);
  model.settle(linear, wavy);
  EXPECT_NEAR(only(model, gauge({0.5})), 0.5, 0.1 * 0.05);
  EXPECT_TRUE(std::isnan(only(model, gauge({1.5}))));
}

TEST(Front, IsHalfASpacingBeyondTheFurthestParticle) {
  const StandingParticles model = pool(2, 0.05);
  for (const auto& [along, place] : {std::pair{"x", 1.0}, {"-x", 0.0}, {"y", 1.0}, {"-y", 0.0}})
    EXPECT_NEAR(only(model, {.name = "f", .type = "front", .along = along}), place, 1e-12) << along;
}

TEST(Speed, IsOfTheFluidAlone) {
  StandingParticles model(2, 0.5);
  model.add({0, 0, 0}, 0);
  model.add({1, 0, 0}, 0);
  model.add({9, 0, 0}, 1);
  model.settle(linear, [](const Triple& place) { return place[0]; });
  const Observer observer({{.name = "s", .type = "speed"}}, {}, model);
  const auto readings = observer.readings(model);
  EXPECT_EQ(readings[0].name, "s_max");
  EXPECT_NEAR(readings[0].value, std::sqrt(5), 1e-15);
  EXPECT_EQ(readings[1].name, "s_rms");
  EXPECT_NEAR(readings[1].value, std::sqrt(2.5), 1e-15);
}

TEST(Force, IsThatOnTheNamedWall) {
  const StandingParticles model = pool(2, 0.1);
  const Observer observer({{.name = "f", .type = "force", .wall = "bed"}}, {}, model);
  const auto readings = observer.readings(model);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].name, "f_x");
  EXPECT_EQ(readings[0].value, 1);
  EXPECT_EQ(readings[1].value, 7);
}

std::string refusal(const std::vector<Probe>& probes) {
  const StandingParticles model = pool(2, 0.1);
  try {
    Observer(probes, {}, model);
  } catch (const InputError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

TEST(Observer, RefusesWhatIsNotThere) {
  EXPECT_THAT(refusal({{.name = "f", .type = "force", .wall = "lid"}}),
              HasSubstr("probes.0.wall: there is no wall 'lid'; there are: bed"));
  EXPECT_THAT(refusal({{.name = "f", .type = "force", .wall = "water"}}), HasSubstr("no wall"));
  Probe density = point({0.5, 0.5});
  density.fields = {"pressure", "density"};
  EXPECT_THAT(refusal({density}),
              HasSubstr("probes.0.fields.1: the model's particles have no dens"));
  density.fields = {"velocity_z"};
  EXPECT_THAT(refusal({density}), HasSubstr("no velocity_z"));
}

TEST(Observer, RefusesColumnsThatAreThereAlready) {
  EXPECT_THAT(refusal({gauge({0.5}), gauge({0.6})}),
              HasSubstr("probes.1.name: history.csv has a column 'g' already"));
  for (const char* name : {"mass", "time", "kinetic_energy"}) {
    Probe probe = gauge({0.5});
    probe.name = name;
    EXPECT_THAT(refusal({probe}), HasSubstr("probes.0.name")) << name;
  }
  Probe twice = point({0.5, 0.5});
  twice.fields = {"velocity", "velocity_x"};
  EXPECT_THAT(refusal({twice}), HasSubstr("'p_velocity_x' already"));
}

}  // namespace
}  // namespace mote::test
