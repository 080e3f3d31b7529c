#include "mote/integrators/stoermer_13.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kepler_problem.hpp"
#include "ladder.hpp"
#include "mote/particles/failure.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

/// Hairer, Norsett & Wanner 1993, Tables III.10.1 and III.1.2 (there gamma*), and further terms of
/// the same series as fractions.
TEST(Stoermer13, HasTheCoefficientsOfTheBook) {
  const auto [gamma, sigma, cowell] = multistep_coefficients(9);
  const std::vector<double> stoermer{1,          0,        1.0 / 12,     1.0 / 12,
                                     19.0 / 240, 3.0 / 40, 863. / 12096, 275. / 4032};
  const std::vector<double> adams{1,           -1.0 / 2,   -1.0 / 12,     -1.0 / 24,
                                  -19.0 / 720, -3.0 / 160, -863. / 60480, -275. / 24192};
  const std::vector<double> implicit{1, -1, 1.0 / 12, 0, -1.0 / 240, -1.0 / 240, -221. / 60480};
  for (std::size_t j = 0; j < stoermer.size(); ++j) EXPECT_NEAR(sigma[j], stoermer[j], 1e-17) << j;
  for (std::size_t j = 0; j < adams.size(); ++j) EXPECT_NEAR(gamma[j], adams[j], 1e-17) << j;
  for (std::size_t j = 0; j < implicit.size(); ++j) EXPECT_NEAR(cowell[j], implicit[j], 1e-17) << j;
}

/// Error on a circle after 14 steps of length 1/n, three of them by the method itself.
double error_on_circle(int n) {
  KeplerProblem system(0);
  Stoermer13 method;
  const double step = 1.0 / n;
  for (int k = 0; k < 14; ++k) method.advance_one_step(system, k * step, step);
  return system.error(14 * step);
}

TEST(Stoermer13, HasOrderThirteen) {
  const Ladder ladder{{5, 6, 7, 8}, 0.3, 2e-13};
  EXPECT_TRUE(has_order(ladder, Stoermer13::order, error_on_circle));
  EXPECT_FALSE(has_order(ladder, Stoermer13::order - 1, error_on_circle));
  EXPECT_FALSE(has_order(ladder, Stoermer13::order + 1, error_on_circle));
}

/// Error of the forced oscillators after 80 steps whose times are multiplied by `clock`.
double error_of_oscillators(double clock) {
  constexpr double end = 4;
  constexpr int steps = 80;
  ForcedOscillators system;
  Stoermer13 method;
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, clock * k * step, step);
  return system.error(end);
}

TEST(Stoermer13, TakesForcesAtTheirTimes) {
  EXPECT_LE(error_of_oscillators(1), 1e-13);
  EXPECT_GT(error_of_oscillators(1 - 1e-6), 1e-8);
}

/// On a circle the first place that is off is the 12th, by sigma_13 h^13 and little more.
TEST(Stoermer13, HasTheErrorOfItsFirstNeglectedTerm) {
  const double h = 0.15;
  KeplerProblem system(0);
  Stoermer13 method;
  for (int k = 0; k < 11; ++k) method.advance_one_step(system, k * h, h);
  EXPECT_LE(system.error(11 * h), 3e-15);
  method.advance_one_step(system, 11 * h, h);
  EXPECT_NEAR(system.position_error(12 * h), 0.0561 * std::pow(h, 13), 0.01 * std::pow(h, 13));
}

TEST(Stoermer13, EvaluatesOnceAStepAfterItsStart) {
  KeplerProblem system(0.05);
  Stoermer13 method;
  const double step = period / 150;
  for (int k = 0; k < 11; ++k) method.advance_one_step(system, k * step, step);
  system.evaluations = 0;
  for (int k = 11; k < 150; ++k) method.advance_one_step(system, k * step, step);
  EXPECT_EQ(system.evaluations, 139);
  EXPECT_LE(system.error(period), 2e-14);
}

TEST(Stoermer13, GoesRoundAHundredTimes) {
  constexpr int steps = 100 * 200;
  const double step = 100 * period / steps;
  KeplerProblem system(0.05);
  Stoermer13 method;
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
  EXPECT_LE(system.error(steps * step), 3e-12);
}

/// State and memory after some steps, with a restart before number `restart`.
std::vector<double> taken(int steps, int restart, bool recalls = true) {
  KeplerProblem system(0.05);
  Stoermer13 first, second;
  const double step = period / 150;
  for (int k = 0; k < steps; ++k) {
    if (k == restart && recalls) second.recall(first.memory());
    (k < restart ? first : second).advance_one_step(system, k * step, step);
  }
  auto result = system.state();
  const auto memory = second.memory();
  result.insert(result.end(), memory.begin(), memory.end());
  return result;
}

TEST(Stoermer13, GoesOnFromItsMemoryWithTheSameBits) {
  const auto through = taken(60, 0);
  for (const int restart : {1, 5, 11, 12, 30}) EXPECT_EQ(taken(60, restart), through) << restart;
  EXPECT_NE(taken(60, 30, false), through);
  EXPECT_TRUE(Stoermer13().memory().empty());
}

TEST(Stoermer13, RefusesTheMemoryOfAnother) {
  Stoermer13 method;
  for (const auto& wrong : {std::vector<double>{1}, std::vector<double>{1, 0, 1},
                            std::vector<double>{1, 13, 1}, std::vector<double>{1, 12, 1}})
    EXPECT_THROW(method.recall(wrong), InputError);
}

/// Steps of one length, then of another, then of the first: a wrong use of old differences would
/// cost far more than 1e-13.
TEST(Stoermer13, BeginsAgainWithAnotherStep) {
  KeplerProblem system(0.05);
  Stoermer13 method;
  double time = 0;
  for (const double step : {period / 150, period / 177, period / 150})
    for (int k = 0; k < 20; ++k, time += step) method.advance_one_step(system, time, step);
  EXPECT_LE(system.error(time), 2e-14);
}

TEST(Stoermer13, TakesTheRoundingOfTimesForWhatItIs) {
  KeplerProblem system(0.05);
  Stoermer13 method;
  const double step = period / 150;
  for (int k = 0; k < 40; ++k)
    method.advance_one_step(system, 10 + k * step, (10 + (k + 1) * step) - (10 + k * step));
  system.evaluations = 0;
  method.advance_one_step(system, 10 + 40 * step, step);
  EXPECT_EQ(system.evaluations, 1);
  EXPECT_LE(system.error(41 * step), 1e-13);  // 41 times the rounding of 10
}

TEST(Stoermer13, SaysWhatItNeeds) {
  DampedOscillator damped;
  KeplerProblem falling(0);
  EXPECT_EQ(Stoermer13().missing_in(damped), "accelerations that depend on time and places alone");
  EXPECT_EQ(Stoermer13().missing_in(falling), "");
}

}  // namespace
}  // namespace mote::test
