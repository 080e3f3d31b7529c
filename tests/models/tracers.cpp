#include "mote/models/tracers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "mote/integrators/runge_kutta_4.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using Formulas = std::map<std::string, PlaceFunction>;

const Formulas& formulas() {
  static const Formulas known{
      {"x", [](const Triple& p, double) { return p[0]; }},
      {"y", [](const Triple& p, double) { return p[1]; }},
      {"-y", [](const Triple& p, double) { return -p[1]; }},
      {"1", [](const Triple&, double) { return 1.0; }},
      {"0", [](const Triple&, double) { return 0.0; }},
      {"cos t", [](const Triple&, double t) { return std::cos(t); }},
      {"sin y", [](const Triple& p, double) { return std::sin(p[1]); }},
      {"r^2", [](const Triple& p, double) { return p[0] * p[0] + p[1] * p[1]; }},
      {"1/x", [](const Triple& p, double) { return 1 / p[0]; }},
      {"sqrt(0.6 - x)", [](const Triple& p, double) { return std::sqrt(0.6 - p[0]); }},
      {"max(0, x - 0.6)", [](const Triple& p, double) { return std::max(0.0, p[0] - 0.6); }},
      {"sqrt(-t)", [](const Triple&, double t) { return std::sqrt(-t); }},
  };
  return known;
}

/// Tracers on a lattice of 10 x 10 within 0.6 of the middle of a square from -1 to 1.
SpaceSetup square() {
  SpaceSetup setup;
  setup.lower = {-1, -1};
  setup.upper = {1, 1};
  setup.spacing = 0.12;
  setup.bodies.emplace_back().name = "fluid";
  for (int i = 0; i < 100; ++i) {
    setup.position.push_back(-0.54 + 0.12 * (i % 10));
    setup.position.push_back(-0.54 + 0.12 * (i / 10));
  }
  setup.body.assign(100, 0);
  setup.compile = [](const std::string& formula) { return formulas().at(formula); };
  return setup;
}

TracersOptions with(const std::vector<std::string>& velocity) {
  return {.velocity = velocity, .mesh = {.spacing = 0.2, .jitter = 0.3}, .invariants = {}};
}

void take_steps(Tracers<2>& tracers, int steps, double step, double start = 0) {
  RungeKutta4 integrator;
  for (int n = 0; n < steps; ++n) {
    const double time = start + n * step;
    integrator.advance_one_step(tracers, time, step);
    tracers.end_step(time, step);
    tracers.update_dependent_fields();
  }
}

void expect_refused(const TracersOptions& options, SpaceSetup setup, const std::string& key,
                    const std::string& words) {
  try {
    Tracers<2>(options, std::move(setup));
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), key);
    EXPECT_THAT(error.what(), testing::HasSubstr(words));
  }
}

double reading(const Tracers<2>& tracers, const std::string& name) {
  for (const Reading& one : tracers.readings())
    if (one.name == name) return one.value;
  throw std::logic_error("no reading " + name);
}

/// The largest distance from places turned about the middle by the time.
double error_of_rotation(const Tracers<2>& tracers, double time) {
  const auto start = square().position;
  const auto position = tracers.cloud().position();
  double worst = 0;
  for (std::size_t k = 0; k < start.size(); k += 2) {
    const double c = std::cos(time), s = std::sin(time);
    worst = std::max(worst, std::hypot(position[k] - c * start[k] + s * start[k + 1],
                                       position[k + 1] - s * start[k] - c * start[k + 1]));
  }
  return worst;
}

/// The largest distance from places moved by the velocity (y, 0), or from images of them two apart.
double error_of_periodic_shear(const Tracers<2>& tracers, double time) {
  const auto start = square().position;
  const auto position = tracers.cloud().position();
  double worst = 0;
  for (std::size_t k = 0; k < start.size(); k += 2) {
    const double way = start[k] + time * start[k + 1] - position[k];
    worst = std::max(
        {worst, std::abs(way - 2 * std::round(way / 2)), std::abs(position[k + 1] - start[k + 1])});
  }
  return worst;
}

TEST(Tracers, FollowLinearVelocitiesExactlyInStepsOfAnyLength) {
  for (const int steps : {1, 3}) {
    Tracers<2> tracers(with({"-y", "x"}), square());
    EXPECT_FALSE(tracers.bears_any_step());
    take_steps(tracers, steps, 9.0 / steps);
    EXPECT_LT(error_of_rotation(tracers, 9), 1e-13);
    EXPECT_EQ(reading(tracers, "share_inside"), 1);
    EXPECT_GT(reading(tracers, "courant_number"), 25);
  }
}

TEST(Tracers, FollowAnIntegratorByRates) {
  TracersOptions options = with({"-y", "x"});
  options.method = TracerMethod::rates;
  double errors[2];
  for (const int k : {0, 1}) {
    Tracers<2> tracers(options, square());
    EXPECT_TRUE(tracers.bears_any_step());
    take_steps(tracers, 20 << k, 0.1 / (1 << k));
    errors[k] = error_of_rotation(tracers, 2);
  }
  EXPECT_GT(errors[1], 1e-10);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4, 0.1);
}

TEST(Tracers, TakeVelocitiesAtTheMiddleOfTheStep) {
  double errors[2];
  for (const int k : {0, 1}) {
    Tracers<2> tracers(with({"cos t", "0"}), square());
    const double start = tracers.cloud().position()[0];
    take_steps(tracers, 2 << k, 0.5 / (1 << k));
    errors[k] = std::abs(tracers.cloud().position()[0] - start - std::sin(1.0));
    EXPECT_NEAR(tracers.cloud().values("velocity")[0], std::cos(1.0), 1e-15);
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.05);
}

TEST(Tracers, StayWhereTheyLeaveAndSaySo) {
  Tracers<2> tracers(with({"1", "0"}), square());
  take_steps(tracers, 1, 1.0);
  EXPECT_NEAR(reading(tracers, "share_inside"), 0.5, 1e-15);
  EXPECT_EQ(tracers.warnings().size(), 1);
  EXPECT_EQ(tracers.cloud().values("left_at")[0], -1);
  EXPECT_NEAR(tracers.cloud().values("left_at")[9], 0.46, 1e-13);
  take_steps(tracers, 1, 1.0, 1.0);
  EXPECT_NEAR(tracers.cloud().position()[18], 1, 1e-13);
  EXPECT_NEAR(reading(tracers, "share_inside"), 0, 1e-15);
}

TEST(Tracers, ComeInAgainWhereTheBoxIsPeriodic) {
  for (const TracerMethod method : {TracerMethod::streamlines, TracerMethod::rates}) {
    SpaceSetup setup = square();
    setup.periodic[0] = true;
    TracersOptions options = with({"y", "0"});
    options.method = method;
    Tracers<2> tracers(options, std::move(setup));
    take_steps(tracers, 1, 20);
    EXPECT_LT(error_of_periodic_shear(tracers, 20), 1e-13);
  }
}

/// Some eps T |u|, however often a tracer came in again.
TEST(Tracers, KeepTheirTimeThroughManySides) {
  SpaceSetup setup = square();
  setup.periodic[0] = true;
  Tracers<2> tracers(with({"y", "0"}), std::move(setup));
  const double time = 3000;
  take_steps(tracers, 1, time);
  EXPECT_GT(reading(tracers, "crossings"), 5000);
  EXPECT_LT(error_of_periodic_shear(tracers, time),
            2 * std::numeric_limits<double>::epsilon() * time * 0.54);
}

TEST(Tracers, GoOnFromASnapshotWithTheSameBits) {
  Tracers<2> first(with({"sin y", "x"}), square());
  take_steps(first, 2, 0.7);
  first.start_afresh();
  Tracers<2> second(with({"sin y", "x"}), square());
  second.restore(first.cloud());
  take_steps(first, 2, 0.7, 1.4);
  take_steps(second, 2, 0.7, 1.4);
  EXPECT_TRUE(std::ranges::equal(first.cloud().position(), second.cloud().position()));
  EXPECT_TRUE(
      std::ranges::equal(first.cloud().values("left_at"), second.cloud().values("left_at")));
}

TEST(Tracers, ReportHowMuchOfInvariantsIsKept) {
  TracersOptions options = with({"-y", "x"});
  options.invariants = {{"square", "r^2"}, {"place", "x"}};
  Tracers<2> tracers(options, square());
  take_steps(tracers, 1, 3.0);
  EXPECT_NEAR(reading(tracers, "square_kept"), 1, 1e-13);
  EXPECT_LT(reading(tracers, "place_kept"), -0.5);
}

/// Of a value that was 0 at the start nothing is kept.
TEST(Tracers, MeasureInvariantsByTheirLargestValueEver) {
  TracersOptions options = with({"1", "0"});
  options.invariants = {{"none", "max(0, x - 0.6)"}};
  Tracers<2> tracers(options, square());
  EXPECT_EQ(reading(tracers, "none_kept"), 1);
  take_steps(tracers, 1, 0.3);
  EXPECT_EQ(reading(tracers, "none_kept"), 0);
}

TEST(Tracers, RefuseInvariantsWithoutValue) {
  TracersOptions options = with({"1", "0"});
  options.invariants = {{"good", "x"}, {"bad", "sqrt(0.6 - x)"}};
  Tracers<2> tracers(options, square());
  EXPECT_NEAR(reading(tracers, "bad_kept"), 1, 0);
  take_steps(tracers, 1, 0.3);
  try {
    tracers.readings();
    FAIL() << "an invariant without value was told";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.what(), testing::HasSubstr("'bad' of tracer 8"));
    EXPECT_EQ(failure.particles(), std::vector<Index>{8});
  }
  SpaceSetup beyond = square();
  beyond.position[14] = 0.7;
  expect_refused(options, std::move(beyond), "model.invariants.1.formula",
                 "starts at (0.7, -0.54)");
}

TEST(Tracers, TakeStepsByTheCourantNumberOfTheMesh) {
  Tracers<2> tracers(with({"1", "0"}), square());
  const double step = tracers.longest_step(0, 25);
  take_steps(tracers, 1, step);
  EXPECT_NEAR(reading(tracers, "courant_number"), 25, 1e-12);
}

TEST(Tracers, RefuseWhatDoesNotFit) {
  EXPECT_THROW(Tracers<2>(with({"1"}), square()), InputError);
  SpaceSetup periodic = square();
  periodic.periodic[0] = true;
  EXPECT_THROW(Tracers<2>(with({"x", "0"}), std::move(periodic)), InputError);
  SpaceSetup walled = square();
  walled.wall_places.resize(1);
  EXPECT_THROW(Tracers<2>(with({"1", "0"}), std::move(walled)), InputError);
}

TEST(Tracers, RefuseVelocitiesWithoutValue) {
  expect_refused(with({"1/x", "0"}), square(), "model.velocity",
                 "no value at (0, -1) at the start");
  TracersOptions rates = with({"1/x", "0"});
  rates.method = TracerMethod::rates;
  EXPECT_NO_THROW(Tracers<2>(rates, square()));  // no tracer starts at x = 0
  SpaceSetup amid = square();
  amid.position[0] = 0;
  expect_refused(rates, std::move(amid), "model.velocity", "no value at (0, -0.54) at the start");
  Tracers<2> later(with({"sqrt(-t)", "0"}), square());
  EXPECT_THROW(take_steps(later, 1, 1), NumericalFailure);
}

TEST(Tracers, HaveInvariantsWithNamesOfColumns) {
  const auto check = [](std::vector<std::string> names) {
    TracersOptions options = with({"1", "0"});
    for (const std::string& name : names) options.invariants.push_back({name, "x"});
    options.check();
  };
  EXPECT_NO_THROW(check({"a", "b_2", "3"}));
  EXPECT_THROW(check({"a", "a"}), InputError);
  for (const char* name : {"a/b", "../x", "a,b", "a b", ""})
    EXPECT_THROW(check({name}), InputError);
}

TEST(TracersRecipe, KnowsItsStepsAndTheMemoryOfItsMesh) {
  TracersRecipe recipe;
  EXPECT_TRUE(recipe.steps_itself());
  EXPECT_TRUE(std::isinf(recipe.largest_courant_number()));
  recipe.options.mesh.spacing = 0.02;
  const OtherMemory memory = recipe.other_memory(square());
  EXPECT_EQ(memory.key, "model.mesh.spacing");
  EXPECT_NEAR(memory.bytes / (101 * 101), 1e3, 500);
  recipe.options.mesh.spacing = 1e-6;
  EXPECT_THROW(recipe.other_memory(square()), InputError);
  recipe.options.method = TracerMethod::rates;
  EXPECT_EQ(recipe.other_memory(square()).bytes, 0);
  EXPECT_FALSE(recipe.steps_itself());
  EXPECT_EQ(recipe.largest_courant_number(), 1);
}

}  // namespace
}  // namespace mote
