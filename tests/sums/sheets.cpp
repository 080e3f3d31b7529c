#include "mote/sums/sheets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/agreement.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

constexpr long double two_pi = 2 * std::numbers::pi_v<long double>;
constexpr double tolerance = 1e-13;

/// Sheets in order of position, and places between, on and beyond them.
struct Sheets : testing::Test {
  static constexpr std::size_t count = 150;
  static constexpr double gravity = 0.7;
  Draws draws{21};
  std::vector<double> position = draws.uniform(count, -3, 5);
  std::vector<double> mass = draws.uniform(count, 0.1, 2);
  std::vector<double> place = draws.uniform(80, -6, 8);

  Sheets() {
    std::ranges::sort(position);
    position[41] = position[40];  // two sheets may touch
    place.insert(place.end(), position.begin(), position.end());
  }

  std::vector<double> acceleration() const {
    std::vector<double> result(count);
    sheet_acceleration(mass, gravity, result);
    return result;
  }

  std::vector<double> potential() const {
    std::vector<double> mass_below(count + 1), moment_below(count + 1), result(place.size());
    sheet_potential(position, mass, gravity, place, mass_below, moment_below, result);
    return result;
  }

  /// sum_j 2 pi G m_j sign(j - i): sheets of higher numbers pull up.
  std::vector<long double> direct_acceleration() const {
    std::vector<long double> result(count);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        if (j != i) result[i] += (j > i ? two_pi : -two_pi) * gravity * mass[j];
    return result;
  }

  /// sum_j 2 pi G m_j |x - x_j|, (39b).
  std::vector<long double> direct_potential() const {
    std::vector<long double> result(place.size());
    for (std::size_t k = 0; k < place.size(); ++k)
      for (std::size_t j = 0; j < count; ++j)
        result[k] +=
            two_pi * gravity * mass[j] * std::abs(static_cast<long double>(place[k]) - position[j]);
    return result;
  }

  long double direct_energy() const {
    long double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        sum += two_pi * gravity * mass[i] * mass[j] *
               std::abs(static_cast<long double>(position[i]) - position[j]);
    return sum;
  }
};

TEST_F(Sheets, AccelerationIsTheSumOverAllPairs) {
  EXPECT_TRUE(agree(acceleration(), direct_acceleration(), tolerance));
}

TEST_F(Sheets, PotentialIsTheSumOverAllPairs) {
  EXPECT_TRUE(agree(potential(), direct_potential(), tolerance));
}

TEST_F(Sheets, EnergyIsTheSumOverAllPairs) {
  const double energy = sheet_energy(position, mass, gravity);
  EXPECT_NEAR(energy, static_cast<double>(direct_energy()), tolerance * energy);
}

TEST_F(Sheets, ForcesAddUpToNothing) {
  const auto a = acceleration();
  double sum = 0, scale = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += mass[i] * a[i];
    scale += std::abs(mass[i] * a[i]);
  }
  EXPECT_LE(std::abs(sum), 1e-14 * scale);
}

TEST_F(Sheets, AccelerationIsTheSlopeOfTheEnergy) {
  for (const std::size_t i : {0u, 70u, 149u}) {
    const double step = 1e-6;
    auto above = position, below = position;
    above[i] += step;
    below[i] -= step;
    ASSERT_TRUE(std::ranges::is_sorted(above) && std::ranges::is_sorted(below));
    const double slope =
        (sheet_energy(above, mass, gravity) - sheet_energy(below, mass, gravity)) / (2 * step);
    EXPECT_NEAR(mass[i] * acceleration()[i], -slope, 1e-5 * std::abs(slope));
  }
}

TEST_F(Sheets, ChecksNoticeOneAlteredMass) {
  const auto a = direct_acceleration(), p = direct_potential();
  const auto energy = static_cast<double>(direct_energy());
  mass[17] *= 1 + 1e-9;
  EXPECT_FALSE(agree(acceleration(), a, tolerance));
  EXPECT_FALSE(agree(potential(), p, tolerance));
  EXPECT_GT(std::abs(sheet_energy(position, mass, gravity) - energy), tolerance * energy);
}

TEST(SheetsAlone, OneSheetDoesNotPullItself) {
  const double mass[] = {3}, position[] = {2};
  double acceleration[] = {1};
  sheet_acceleration(mass, 0.5, acceleration);
  EXPECT_EQ(acceleration[0], 0);
  EXPECT_EQ(sheet_energy(position, mass, 0.5), 0);
}

}  // namespace
}  // namespace mote::test
