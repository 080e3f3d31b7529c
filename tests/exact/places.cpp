#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "mote/exact/gravitating_sheets.hpp"
#include "sheet_cells.hpp"

namespace mote::test {
namespace {

double total_mass(const SheetCells& cells) {
  return std::accumulate(cells.mass.begin(), cells.mass.end(), 0.0);
}

/// The gas at one place.
struct Gas {
  double velocity, density;
};
Gas gas_at(const GravitatingSheets& solution, double place, double time) {
  const Table table = solution.at_places({&place, 1}, time);
  return {table[0].values[0], table[1].values[0]};
}

/// Mass under the curve: each cell is a pair of points at the same density.
double mass_under(const Table& curve) {
  const auto &x = curve[0].values, &rho = curve[2].values;
  double mass = 0;
  for (std::size_t k = 0; k + 1 < x.size(); k += 2) mass += rho[k] * (x[k + 1] - x[k]);
  return mass;
}

struct MovingSheets : testing::Test {
  SheetCells cells = moving_cells(slab, 0.0015, 0.2, -0.02);
  GravitatingSheets solution{cells};
  double time = 6;
};

TEST_F(MovingSheets, CurveHoldsTheWholeMass) {
  for (const double t : {0.0, 1.0, time})
    EXPECT_NEAR(mass_under(solution.curve(t)), total_mass(cells), 1e-13 * total_mass(cells));
}

TEST_F(MovingSheets, CurveHasNoGaps) {
  const auto x = solution.curve(time)[0].values;
  ASSERT_EQ(x.size(), 2 * cells.length.size());
  for (std::size_t k = 1; k + 1 < x.size(); k += 2) EXPECT_EQ(x[k], x[k + 1]);
  EXPECT_EQ(solution.curve(0)[0].values.front(), cells.lower);
  EXPECT_NEAR(solution.curve(0)[0].values.back(), 4, 1e-14);
}

TEST_F(MovingSheets, MassAtPlacesIntegratesToTheTotal) {
  // The density is constant in each cell, so the middle of each cell stands for all of it.
  const auto x = solution.curve(time)[0].values;
  std::vector<double> middle;
  for (std::size_t k = 0; k < x.size(); k += 2) middle.push_back((x[k] + x[k + 1]) / 2);
  const Table gas = solution.at_places(middle, time);
  double mass = 0;
  for (std::size_t i = 0; i < middle.size(); ++i)
    mass += gas[1].values[i] * (x[2 * i + 1] - x[2 * i]);
  EXPECT_NEAR(mass, total_mass(cells), 1e-13 * mass);
}

TEST_F(MovingSheets, FineSumOverPlacesGivesTheMassToo) {
  constexpr int count = 400'000;
  const auto x = solution.curve(time)[0].values;
  const double lower = x.front() - 1, width = (x.back() - x.front() + 2) / count;
  std::vector<double> place;
  for (int k = 0; k < count; ++k) place.push_back(lower + (k + 0.5) * width);
  const auto density = solution.at_places(place, time)[1].values;
  const double mass = width * std::accumulate(density.begin(), density.end(), 0.0);
  EXPECT_NEAR(mass, total_mass(cells), 1e-4 * mass);
}

TEST_F(MovingSheets, VacuumHasNoDensityAndNoVelocity) {
  const auto x = solution.curve(time)[0].values;
  for (const double place : {x.front() - 1e-9, x.back() + 1e-9, -1e6, 1e6}) {
    const Gas gas = gas_at(solution, place, time);
    EXPECT_TRUE(std::isnan(gas.velocity)) << place;
    EXPECT_EQ(gas.density, 0) << place;
  }
  EXPECT_GT(gas_at(solution, x.front() + 1e-9, time).density, 0);
  EXPECT_GT(gas_at(solution, x.back() - 1e-9, time).density, 0);
}

TEST_F(MovingSheets, PlacesAndParticlesTellTheSameStory) {
  const Table particles = solution.of_particles(time);
  const Table places = solution.at_places(particles[0].values, time);
  for (std::size_t i = 0; i < cells.mass.size(); ++i) {
    EXPECT_NEAR(places[0].values[i], particles[1].values[i], 1e-13);
    EXPECT_NEAR(places[1].values[i], particles[2].values[i], 1e-12);
  }
}

TEST_F(MovingSheets, VelocityIsContinuousAcrossEdges) {
  const auto x = solution.curve(time)[0].values;
  for (std::size_t k = 1; k + 1 < x.size(); k += 2)
    EXPECT_NEAR(gas_at(solution, x[k] - 1e-9, time).velocity,
                gas_at(solution, x[k] + 1e-9, time).velocity, 1e-8);
}

}  // namespace
}  // namespace mote::test
