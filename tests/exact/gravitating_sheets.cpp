#include "mote/exact/gravitating_sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sheet_cells.hpp"
#include "support/agreement.hpp"

namespace mote::test {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr double tolerance = 1e-13;

struct Expected {
  std::vector<long double> position, velocity, density;
};

/// x = a + u t + g t^2/2 with g = -4 pi G (m - M/2), and rho = rho0/(1 + u' t - 2 pi G rho0 t^2);
/// m by an O(N^2) sum in which a particle's own cell counts by half.
Expected formulas(const SheetCells& cells, long double t) {
  Expected expected;
  const std::size_t count = cells.position.size();
  for (std::size_t i = 0; i < count; ++i) {
    long double below = 0, total = 0;
    for (std::size_t j = 0; j < count; ++j) {
      total += cells.mass[j];
      below += j < i ? cells.mass[j] : j == i ? cells.mass[j] / 2.0L : 0;
    }
    const long double G = cells.gravity, g = -4 * pi * G * (below - total / 2);
    const long double rho0 = cells.mass[i] / static_cast<long double>(cells.length[i]);
    const long double slope = cells.length_rate[i] / static_cast<long double>(cells.length[i]);
    expected.position.push_back(cells.position[i] + cells.velocity[i] * t + g * t * t / 2);
    expected.velocity.push_back(cells.velocity[i] + g * t);
    expected.density.push_back(rho0 / (1 + slope * t - 2 * pi * G * rho0 * t * t));
  }
  return expected;
}

testing::AssertionResult follows_formulas(const SheetCells& cells, double time,
                                          const SheetCells& reference) {
  const Table table = GravitatingSheets(cells).of_particles(time);
  const Expected expected = formulas(reference, time);
  if (table[0].name != "position" || table[1].name != "velocity" || table[2].name != "density")
    return testing::AssertionFailure() << "columns";
  if (auto right = agree(table[0].values, expected.position, tolerance); !right) return right;
  if (auto right = agree(table[1].values, expected.velocity, tolerance); !right) return right;
  return agree(table[2].values, expected.density, tolerance);
}

TEST(GravitatingSheets, FollowTheFormulasFromRest) {
  for (const Profile& density : {Profile(slab), Profile(ramp)})
    for (const double time : {0.5, 3.0, 7.5}) {
      const SheetCells cells = cells_at_rest(density, 0.0015);
      EXPECT_TRUE(follows_formulas(cells, time, cells)) << time;
    }
}

TEST(GravitatingSheets, FollowTheFormulasWithInitialVelocities) {
  for (const double slope : {-0.03, 0.0, 0.4})
    for (const double time : {0.5, 3.0, 7.5}) {
      const SheetCells cells = moving_cells(ramp, 0.0015, -0.3, slope);
      EXPECT_TRUE(follows_formulas(cells, time, cells)) << slope << ", " << time;
    }
}

TEST(GravitatingSheets, CheckNoticesAnotherGravity) {
  const SheetCells cells = cells_at_rest(ramp, 0.0015);
  EXPECT_FALSE(follows_formulas(cells_at_rest(ramp, 0.0015 * (1 + 1e-9)), 7.5, cells));
  EXPECT_FALSE(follows_formulas(cells_at_rest(ramp, -0.0015), 0.5, cells));
}

TEST(GravitatingSheets, StartWhereTheyAre) {
  const SheetCells cells = moving_cells(slab, 0.0015, 0.1, 0.2);
  const Table table = GravitatingSheets(cells).of_particles(0);
  EXPECT_EQ(table[0].values, cells.position);
  EXPECT_EQ(table[1].values, cells.velocity);
}

TEST(GravitatingSheets, FromRestCrossWhenTheDensestCellHasCollapsed) {
  const double expected = static_cast<double>(1 / std::sqrt(2 * pi * 0.0015L * 1.025L));
  EXPECT_NEAR(expected, 10.17, 0.005);
  const GravitatingSheets solution(cells_at_rest(slab, 0.0015));
  EXPECT_NEAR(solution.first_crossing(), expected, 1e-13 * expected);
  EXPECT_EQ(solution.valid_until(), solution.first_crossing());
}

TEST(GravitatingSheets, CrossEarlierWhenTheyFallTogether) {
  const double shrink = 0.25;  // 1 - shrink t - 2 pi G rho t^2 = 0
  const double c = static_cast<double>(2 * pi * 0.0015L * 1.025L);
  const double expected = (-shrink + std::sqrt(shrink * shrink + 4 * c)) / (2 * c);
  const GravitatingSheets solution(moving_cells(slab, 0.0015, 0.3, -shrink));
  EXPECT_NEAR(solution.first_crossing(), expected, 1e-13 * expected);
}

TEST(GravitatingSheets, WithoutGravityCrossByTheirVelocitiesAlone) {
  EXPECT_NEAR(GravitatingSheets(moving_cells(ramp, 0, 1, -0.5)).first_crossing(), 2, 1e-12);
  constexpr double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(GravitatingSheets(moving_cells(ramp, 0, 1, 0.5)).first_crossing(), never);
  EXPECT_EQ(GravitatingSheets(cells_at_rest(ramp, 0)).first_crossing(), never);
}

TEST(GravitatingSheets, ParticlesThatMeetBeforeTheirCellsCollapseCross) {
  SheetCells cells{{0.5, 1.5}, {1, -1}, {1, 1}, {0, 0}, {1, 1}};
  EXPECT_NEAR(GravitatingSheets(cells).first_crossing(), 0.5, 1e-15);
}

TEST(GravitatingSheets, RefuseTimesAtAndAfterTheCrossing) {
  const GravitatingSheets solution(cells_at_rest(slab, 0.0015));
  const double crossing = solution.first_crossing();
  const double place[] = {2};
  EXPECT_NO_THROW(solution.of_particles(std::nextafter(crossing, 0)));
  for (const double time : {crossing, crossing * 1.01, 1e6}) {
    EXPECT_THROW(solution.of_particles(time), std::domain_error) << time;
    EXPECT_THROW(solution.at_places(place, time), std::domain_error) << time;
    EXPECT_THROW(solution.curve(time), std::domain_error) << time;
  }
}

TEST(GravitatingSheets, RefuseCellsThatAreNone) {
  SheetCells uneven = cells_at_rest(ramp, 1);
  uneven.mass.pop_back();
  EXPECT_THROW(GravitatingSheets{uneven}, std::invalid_argument);
  SheetCells flat = cells_at_rest(ramp, 1);
  flat.length[3] = 0;
  EXPECT_THROW(GravitatingSheets{flat}, std::invalid_argument);
  EXPECT_THROW(GravitatingSheets{SheetCells{}}, std::invalid_argument);
}

}  // namespace
}  // namespace mote::test
