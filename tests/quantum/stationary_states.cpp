#include "mote/quantum/stationary_states.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mote/particles/failure.hpp"
#include "mote/quantum/gauss_rules.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

SchroedingerProblem infinite_well(int intervals) {
  return {.potential = [](double) { return 0.0; },
          .lower = 0,
          .upper = 1,
          .intervals = intervals,
          .form = WaveForm::plain,
          .decay_below = {},
          .decay_above = {}};
}

/// Tails that fall as the ground state does at the ends.
SchroedingerProblem harmonic_oscillator(int intervals, double end) {
  return {.potential = [](double x) { return x * x; },
          .lower = -end,
          .upper = end,
          .intervals = intervals,
          .form = WaveForm::plain,
          .decay_below = end,
          .decay_above = end};
}

/// With no slope at the end, section 4.4.
SchroedingerProblem coulomb(int intervals, double end) {
  return {.potential = [](double r) { return -2 / r; },
          .lower = 0,
          .upper = end,
          .intervals = intervals,
          .form = WaveForm::radial,
          .decay_below = {},
          .decay_above = 1 / end};
}

/// Relative errors of energies of the well, (n pi)^2.
std::vector<double> well_errors(int intervals) {
  const StationaryStates states(infinite_well(intervals), 2 * intervals);
  std::vector<double> errors;
  for (int n = 1; n <= 2 * intervals; ++n)
    errors.push_back(states.energies()[n - 1] / std::pow(n * pi, 2) - 1);
  return errors;
}

double ground_state_error(int intervals) {
  return StationaryStates(coulomb(intervals, 1), 1).energies()[0] + 1;
}

TEST(InfiniteWell, HasTheMatricesOfThePaperForOneInterval) {
  const SchroedingerMatrices matrices = schroedinger_matrices(infinite_well(1));
  Eigen::Matrix2d p, q, h;  // (4.2.14), where P and Q are twice the integrals, and (4.2.15)
  p << 2 / 105.0, -1 / 70.0, -1 / 70.0, 2 / 105.0;
  q << -4 / 15.0, 1 / 15.0, 1 / 15.0, -4 / 15.0;
  h << 26, 16, 16, 26;
  EXPECT_LE((2 * matrices.p - p).norm(), 1e-16);
  EXPECT_LE((2 * matrices.q - q).norm(), 1e-15);
  EXPECT_LE((matrices.p.lu().solve(-matrices.q) - h).norm(), 1e-12);
}

TEST(InfiniteWell, HasEnergies10And42ForOneInterval) {
  const StationaryStates states(infinite_well(1), 2);
  EXPECT_NEAR(states.energies()[0], 10, 1e-13);
  EXPECT_NEAR(states.energies()[1], 42, 1e-13);
  for (const double x : {0.1, 0.25, 0.7}) {  // (4.2.16)
    EXPECT_NEAR(states.wave_function(0, x), std::sqrt(30) * (x - x * x), 1e-14);
    EXPECT_NEAR(states.wave_function(1, x), std::sqrt(210) * (x - 3 * x * x + 2 * x * x * x),
                1e-14);
  }
}

/// Figure 4.2.3: errors below 1.4% up to n = N, the worst at 2N - 1, the same 42/(2 pi)^2 - 1 at
/// 2N.
TEST(InfiniteWell, ErrsAsInThePaper) {
  for (const int intervals : {2, 4, 8}) {
    const auto errors = well_errors(intervals), coarser = well_errors(intervals / 2);
    const auto last = static_cast<std::size_t>(2 * intervals - 1);
    EXPECT_NEAR(errors[last], 42 / (4 * pi * pi) - 1, 1e-12);
    EXPECT_NEAR(errors[last / 2], 10 / (pi * pi) - 1, 1e-12);
    EXPECT_LE(errors[last / 2 - 1], 0.0133);
    EXPECT_LT(errors[0], coarser[0] / 32);
    EXPECT_EQ(errors[last - 1] > errors[last], intervals > 2);
  }
  EXPECT_NEAR(std::log2(well_errors(16)[1] / well_errors(32)[1]), 6, 0.25);
}

TEST(HarmonicOscillator, HasOddEnergies) {
  const StationaryStates coarse(harmonic_oscillator(16, 5), 6), fine(harmonic_oscillator(32, 5), 6);
  for (int n = 0; n < 6; ++n) {
    const double exact = 2 * n + 1;
    EXPECT_NEAR(fine.energies()[n], exact, 1e-5 * exact) << n;
    EXPECT_NEAR(std::log2((coarse.energies()[n] - exact) / (fine.energies()[n] - exact)), 5.5, 0.5);
  }
}

/// The tails carry what walls at the same places would cut off.
TEST(HarmonicOscillator, NeedsItsTails) {
  SchroedingerProblem walls = harmonic_oscillator(32, 3);
  walls.decay_below = walls.decay_above = {};
  EXPECT_LE(StationaryStates(harmonic_oscillator(32, 3), 1).energies()[0] - 1, 1.5e-6);
  EXPECT_GT(StationaryStates(walls, 1).energies()[0] - 1, 5e-4);
}

TEST(Coulomb, HasTheGroundStateOfThePaper) {
  EXPECT_LE(std::abs(ground_state_error(8)), 5e-10);
  for (int intervals = 3; intervals <= 8; ++intervals)
    EXPECT_LT(ground_state_error(intervals), 0.5 * ground_state_error(intervals - 1));
  const StationaryStates states(coulomb(8, 1), 1);
  for (const double r : {0.05, 0.4, 0.99, 1.3, 4.0})
    EXPECT_NEAR(states.wave_function(0, r), 2 * r * std::exp(-r), 1e-6) << r;
}

/// Where the domain ends, and its tail begins, matters: the exact tail is the one from r = 1 on.
TEST(Coulomb, DependsOnItsTail) {
  EXPECT_GT(StationaryStates(coulomb(8, 1.5), 1).energies()[0] + 1, 1e-6);
}

/// The functions have no kinks and vanish at walls, so Q, other than its pieces, is symmetric.
TEST(SchroedingerMatrices, AreSymmetric) {
  for (const auto& problem : {infinite_well(5), harmonic_oscillator(5, 3), coulomb(5, 1)}) {
    const SchroedingerMatrices matrices = schroedinger_matrices(problem);
    EXPECT_LE((matrices.q - matrices.q.transpose()).norm(), 1e-14 * matrices.q.norm());
    EXPECT_LE((matrices.p - matrices.p.transpose()).norm(), 1e-14 * matrices.p.norm());
  }
}

TEST(StationaryStates, AreOrthonormalWithTheirTails) {
  const StationaryStates states(harmonic_oscillator(12, 3), 4);
  constexpr int points = 20000;
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  for (int k = 0; k < points; ++k) {
    const double x = -8 + 16.0 * (k + 0.5) / points;
    Eigen::Vector4d psi;
    for (int n = 0; n < 4; ++n) psi[n] = states.wave_function(n, x);
    products += 16.0 / points * psi * psi.transpose();
  }
  EXPECT_LE((products - Eigen::Matrix4d::Identity()).norm(), 1e-6);
  EXPECT_GT(states.wave_function(0, -4.0), 0);
}

TEST(StationaryStates, FailWhereNumbersDoNotSuffice) {
  for (const double end : {1e-160, 1e160})
    EXPECT_THROW(StationaryStates(harmonic_oscillator(8, end), 1), NumericalFailure) << end;
  SchroedingerProblem steep = harmonic_oscillator(8, 5);
  steep.decay_above = 1e200;
  EXPECT_THROW(StationaryStates(steep, 1), NumericalFailure);
  steep.decay_above = 1e3;
  EXPECT_NO_THROW(StationaryStates(steep, 1));
}

TEST(StationaryStates, RefuseMoreThanThereAre) {
  EXPECT_THROW(StationaryStates(infinite_well(2), 5), std::domain_error);
  EXPECT_THROW(StationaryStates(infinite_well(0), 1), std::domain_error);
}

TEST(GaussRules, AreExactForPolynomials) {
  const GaussRule legendre = gauss_legendre(5), laguerre = gauss_laguerre(5);
  double factorial = 1;
  for (int power = 0; power <= 9; ++power) {
    if (power > 0) factorial *= power;
    EXPECT_NEAR(legendre.weight.dot(legendre.place.array().pow(power).matrix()), 1.0 / (power + 1),
                1e-15);
    EXPECT_NEAR(laguerre.weight.dot(laguerre.place.array().pow(power).matrix()), factorial,
                1e-13 * factorial);
  }
  EXPECT_GT(std::abs(legendre.weight.dot(legendre.place.array().pow(10).matrix()) - 1.0 / 11),
            1e-7);
}

}  // namespace
}  // namespace mote::test
