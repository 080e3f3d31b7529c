#include "mote/exact/burgers_cole_hopf.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace mote::test {
namespace {

double flat_slope_flat(double x) { return std::clamp(-(2.0 / 4) * (x - 2), -0.5, 0.5); }
double wavy(double x) { return 1 + 0.5 * std::sin(x); }
double jump_up(double x) { return x < 1.3 ? -0.2 : 0.4; }

/// Particles at equal distances on [0, 4]; an odd number of them has one in the middle.
BurgersStart start_of(
    std::function<double(double)> velocity, double viscosity, int count = 41,
    std::function<double(double)> density = [](double) { return 1.0; }) {
  BurgersStart start{velocity, density, {}, 0, 4, viscosity};
  for (int i = 0; i < count; ++i) start.particles.push_back(4 * (i + 0.5) / count);
  return start;
}

double density_in_the_middle(double viscosity, double time) {
  return BurgersColeHopf(start_of(flat_slope_flat, viscosity, 3)).of_particles(time)[2].values[1];
}

TEST(BurgersColeHopf, DensityPeakOfThePaper) {
  EXPECT_NEAR(density_in_the_middle(0.02, 2), 14.6, 0.05);
  EXPECT_NEAR(density_in_the_middle(0.02, 2.5), 134.9, 0.05);
  EXPECT_GT(std::abs(density_in_the_middle(0.0201, 2.5) - 134.9), 0.5);
}

/// Follows X' = u, J' = u_x J in t with another method and steps, from where the start is still
/// that of the particle to 1e-10.
std::array<double, 2> followed(const std::function<double(double)>& start, double viscosity,
                               double label, double end, double error) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  ColeHopf motion(start, 0, 4, viscosity);
  motion.cover(-3, 7, end);
  const double first = 1e-10;
  State state{label + start(label) * first, 1};
  const auto rates = [&](const State& at, State& rate, double time) {
    const auto [velocity, slope] = motion(at[0], time);
    rate = {velocity, slope * at[1]};
  };
  odeint::integrate_adaptive(
      odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(error, error), rates, state, first,
      end, first);
  return state;
}

void expect_same_paths(const std::function<double(double)>& start, double viscosity, double end) {
  const std::vector<double> labels{0.3, 0.99, 1.01, 1.9};
  BurgersStart setup = start_of(start, viscosity);
  setup.particles = labels;
  const Table table = BurgersColeHopf(setup).of_particles(end);
  double largest_coarse = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto difference = [&](double error) {
      const auto [place, stretch] = followed(start, viscosity, labels[i], end, error);
      return std::max(std::abs(table[0].values[i] - place),
                      std::abs(table[2].values[i] * stretch - 1));
    };
    largest_coarse = std::max(largest_coarse, difference(1e-5));
    EXPECT_LT(difference(1e-11), 1e-9) << labels[i];
  }
  EXPECT_GT(largest_coarse, 1e-7);
}

TEST(BurgersColeHopf, PathsAreThoseOfAnotherMethod) {
  expect_same_paths(flat_slope_flat, 0.02, 2.5);
  expect_same_paths(flat_slope_flat, 2e-3, 1.5);
  expect_same_paths(wavy, 0.05, 2);
}

/// Mass between the first and the last particle by sums of the density at places between
/// neighbours, relative to that at the start.
double mass_gained(const BurgersStart& start, double time, double start_mass) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  const BurgersColeHopf solution(start);
  const std::vector<double> x = solution.of_particles(time)[0].values;
  std::vector<double> places, shares;
  for (std::size_t i = 1; i < x.size(); ++i)
    for (std::size_t n = 0; n < Rule::abscissa().size(); ++n)
      for (const int side : {-1, 1}) {
        const double half = 0.5 * (x[i] - x[i - 1]);
        places.push_back(0.5 * (x[i - 1] + x[i]) + side * half * Rule::abscissa()[n]);
        shares.push_back(half * Rule::weights()[n]);
      }
  const Table table = solution.at_places(places, time);
  double mass = 0;
  for (std::size_t k = 0; k < places.size(); ++k) mass += shares[k] * table[1].values[k];
  return mass / start_mass - 1;
}

/// Particles in the layer, near enough for sums between them.
TEST(BurgersColeHopf, DensityBetweenParticlesHoldsTheirMass) {
  BurgersStart start = start_of(flat_slope_flat, 0.02, 6);
  for (double& label : start.particles) label = 1.7 + 0.1 * label;
  const double first = start.particles.front(), last = start.particles.back();
  EXPECT_NEAR(mass_gained(start, 2, last - first), 0, 1e-10);
  EXPECT_GT(std::abs(mass_gained(start, 2, last - first + 1e-8)), 1e-9);
}

TEST(BurgersColeHopf, UnevenDensityHoldsItsMass) {
  BurgersStart start = start_of(wavy, 0.1, 5, [](double x) { return 1 + x; });
  for (double& label : start.particles) label = 2 + 0.25 * label;
  const double first = start.particles.front(), last = start.particles.back();
  const double mass = last - first + (last * last - first * first) / 2;
  EXPECT_NEAR(mass_gained(start, 3, mass), 0, 1e-10);
}

TEST(BurgersColeHopf, PlacesAndParticlesTellTheSameStory) {
  for (const auto& velocity : {flat_slope_flat, wavy, jump_up}) {
    const BurgersColeHopf solution(start_of(velocity, 0.02, 7));
    for (const double time : {0.0, 0.3, 1.5}) {
      const Table particles = solution.of_particles(time);
      const Table places = solution.at_places(particles[0].values, time);
      for (std::size_t i = 0; i < 7; ++i) {
        const double rho = particles[2].values[i];
        EXPECT_EQ(places[0].values[i], particles[1].values[i]);
        EXPECT_NEAR(places[1].values[i] / rho, 1, 1e-11) << i << " at " << time;
      }
    }
  }
}

TEST(BurgersColeHopf, DensityIsUnknownWhereAPlaceDoesNotSayWhichGasIsThere) {
  const BurgersColeHopf solution(start_of(flat_slope_flat, 1e-3));
  const Table gas = solution.at_places(std::vector<double>{1.5, 2}, 2.5);
  EXPECT_NEAR(gas[1].values[0], 1, 1e-11);
  EXPECT_TRUE(std::isnan(gas[1].values[1]));
  EXPECT_NEAR(gas[0].values[1], 0, 1e-15);
}

/// By symmetry a particle at a jump stays. At first viscosity alone spreads the jump from -U to U,
/// so u_x = U/sqrt(pi nu t) there, and ln J = 2 U sqrt(t/(pi nu)).
TEST(BurgersColeHopf, ParticleAtAJump) {
  BurgersStart start = start_of([](double x) { return x < 2 ? -0.5 : x > 2 ? 0.5 : 0.0; }, 0.02, 3);
  const BurgersColeHopf solution(start);
  const double time = 1e-8;
  const Table table = solution.of_particles(time);
  EXPECT_NEAR(table[0].values[1], 2, 1e-14);
  const double log_stretch = 2 * 0.5 * std::sqrt(time / (std::numbers::pi * 0.02));
  EXPECT_NEAR(-std::log(table[2].values[1]), log_stretch, log_stretch * log_stretch);
  EXPECT_GT(std::abs(-std::log(table[2].values[1])), 0.9 * log_stretch);
}

TEST(BurgersColeHopf, CurveResolvesTheProfile) {
  const BurgersColeHopf solution(start_of(flat_slope_flat, 0.004, 3));
  const Table curve = solution.curve(2.2);
  EXPECT_TRUE(std::ranges::is_sorted(curve[0].values));
  EXPECT_LT(curve[0].values.size(), 600);
  const auto& u = curve[1].values;
  for (std::size_t k = 1; k < u.size(); ++k) EXPECT_LT(std::abs(u[k] - u[k - 1]), 0.03);
  const double peak = solution.of_particles(2.2)[2].values[1];
  EXPECT_NEAR(std::ranges::max(curve[2].values), peak, 1e-9 * peak);
}

TEST(BurgersColeHopf, SameBitsOnAnyNumberOfThreads) {
  const BurgersColeHopf solution(start_of(wavy, 0.02, 11));
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Table alone = solution.of_particles(1);
  omp_set_num_threads(3);
  const Table shared = solution.of_particles(1);
  omp_set_num_threads(threads_before);
  for (std::size_t column = 0; column < alone.size(); ++column)
    EXPECT_EQ(alone[column].values, shared[column].values);
}

TEST(BurgersColeHopf, LaterAndEarlierTimesInAnyOrder) {
  const BurgersColeHopf once(start_of(wavy, 0.02, 5)), again(start_of(wavy, 0.02, 5));
  again.of_particles(3);
  again.of_particles(0.1);
  EXPECT_EQ(once.of_particles(1)[2].values, again.of_particles(1)[2].values);
}

TEST(BurgersColeHopf, EndsTheSoonerTheFasterItsWavesAre) {
  const auto fast = [](double x) { return 1e4 * wavy(x); };
  const double usual = BurgersColeHopf(start_of(wavy, 0.02, 3)).valid_until();
  const double short_lived = BurgersColeHopf(start_of(fast, 0.02, 3)).valid_until();
  EXPECT_GT(usual, 100);
  EXPECT_NEAR(usual / short_lived, 1e4, 1e3);
}

TEST(BurgersColeHopf, RefusesWhatItHasNoAnswerFor) {
  const auto refused = [](BurgersStart start) {
    EXPECT_THROW(BurgersColeHopf{start}, std::invalid_argument);
  };
  refused(start_of(wavy, 0));
  refused(start_of(wavy, -1));
  refused(start_of(wavy, std::numeric_limits<double>::infinity()));
  refused(start_of(wavy, 0.1, 0));
  refused(start_of([](double x) { return -x; }, 0.1));
  refused(start_of([](double x) { return std::sqrt(x); }, 0.1));
  BurgersStart without_length = start_of(wavy, 0.1);
  without_length.upper = 0;
  refused(without_length);
}

}  // namespace
}  // namespace mote::test
