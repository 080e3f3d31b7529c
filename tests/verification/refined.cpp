// The reference on refined cells against solutions in closed form, and what it says of itself.

#include "mote/catalogue/refined.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mote/exact/burgers_cole_hopf.hpp"
#include "mote/models/pressureless_gas.hpp"
#include "support/line_gas.hpp"

namespace mote::test {
namespace {

constexpr Index count = 21;

/// The gas refined, with a viscosity.
Refined refined(const LineGas& gas, double viscosity) {
  PressurelessGasRecipe recipe;
  recipe.options.gravity = gas.gravity;
  recipe.options.viscosity = viscosity;
  return Refined(
      [gas, recipe](int pieces) {
        LineSetup setup;
        setup.upper = gas.upper;
        setup.ends = gas.ends;
        setup.cells = cells_of_line<Regular>(0, gas.upper, count * pieces, 0);
        setup.initial = [gas](std::string_view field, double x) {
          return field == "density" ? gas.density(x) : gas.velocity(x);
        };
        return recipe.make_reference(std::move(setup));
      },
      count);
}

/// A wave whose mirror images between walls are the wave itself, on the whole line.
LineGas sine() {
  return {"sine",
          0,
          [](double) { return 1.0; },
          [](double x) { return 0.4 * std::sin(std::numbers::pi * x / 2); },
          4,
          LineEnds::wall};
}

double relative_error(const std::vector<double>& values, const std::vector<double>& reference) {
  double error = 0, size = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    error += std::pow(values[i] - reference[i], 2);
    size += std::pow(reference[i], 2);
  }
  return std::sqrt(error / size);
}

/// Errors of velocity and density at t = 1 against Cole and Hopf with a viscosity of 0.05.
std::pair<double, double> errors(double viscosity) {
  const LineGas gas = sine();
  const Cells cells = cells_of_line<Regular>(0, gas.upper, count, 0);
  const BurgersColeHopf exact({gas.velocity, gas.density, cells.centre, 0, gas.upper, 0.05});
  const Table expected = exact.of_particles(1), found = refined(gas, viscosity).of_particles(1);
  return {relative_error(found[1].values, expected[1].values),
          relative_error(found[2].values, expected[2].values)};
}

TEST(Refined, IsCloseToTheSolutionInClosedForm) {
  const auto [velocity, density] = errors(0.05);
  EXPECT_LT(velocity, 2e-5);
  EXPECT_LT(density, 2e-5);
}

TEST(Refined, CheckNoticesOnePercentOfViscosity) { EXPECT_GT(errors(0.0505).first, 1e-4); }

/// The number behind a word of a statement.
double number_before(const std::string& text, const std::string& word) {
  const auto end = text.find(" in " + word);
  const auto start = text.rfind(' ', end - 1);
  return std::stod(text.substr(start, end - start));
}

TEST(Refined, SaysHowFarItIsOff) {
  const Refined reference = refined(sine(), 0.05);
  EXPECT_EQ(reference.statement().find("off by about"), std::string::npos);
  reference.of_particles(1);
  const auto [velocity, density] = errors(0.05);
  EXPECT_GT(number_before(reference.statement(), "velocity"), velocity / 3);
  EXPECT_LT(number_before(reference.statement(), "velocity"), velocity * 3);
  EXPECT_GT(number_before(reference.statement(), "density"), density / 3);
  EXPECT_LT(number_before(reference.statement(), "density"), density * 3);
}

TEST(Refined, ShowsAtPlacesWhatTheParticlesThereHave) {
  const Refined reference = refined(sine(), 0.05);
  const Table particles = reference.of_particles(1);
  const Table places = reference.at_places(particles[0].values, 1);
  EXPECT_EQ(places[0].name, "velocity");
  EXPECT_LT(relative_error(places[0].values, particles[1].values), 1e-12);
  EXPECT_LT(relative_error(places[1].values, particles[2].values), 1e-12);
  const Table outside = reference.at_places(std::vector<double>{-1, 5}, 1);
  EXPECT_TRUE(std::isnan(outside[0].values[0]));
  EXPECT_EQ(outside[1].values[1], 0);
}

}  // namespace
}  // namespace mote::test
