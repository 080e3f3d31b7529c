#include "mote/integrators/wisdom_holman.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mote/integrators/gauss_radau_15.hpp"
#include "mote/integrators/velocity_verlet.hpp"
#include "point_masses.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

/// Two bodies one apart, at the pericentre of their orbit, about a centre that moves.
MassPoints two_bodies(double eccentricity) {
  return {
      1, {0.75, 0.25}, {0.5, 0, 0, 1.5, 0, 0}, {0.1, 0, 0, 0.1, std::sqrt(1 + eccentricity), 0}};
}

MassPoints moved_exactly(double eccentricity, double time) {
  MassPoints bodies = two_bodies(eccentricity);
  GaussRadau15 method;
  for (double now = 0; time - now > 1e-15 * time;) now += method.advance(bodies, now, time - now);
  return bodies.copy();
}

void take_steps(MassPoints& bodies, Integrator& method, int steps, double step) {
  for (int k = 0; k < steps; ++k) method.advance_one_step(bodies, k * step, step);
}

/// How far this many steps are off for two bodies, at whatever step.
double error_for_two(double eccentricity, int steps, double step) {
  MassPoints bodies = two_bodies(eccentricity);
  WisdomHolman method;
  take_steps(bodies, method, steps, step);
  const MassPoints exact = moved_exactly(eccentricity, steps * step);
  return distance(bodies.position, exact.position) / (1 + steps * step);
}

TEST(WisdomHolman, MovesTwoBodiesExactlyByAnyStep) {
  for (const double step : {0.01, 0.3, 1.0, 4.0, 11.0})
    for (const double eccentricity : {0.0, 0.3, 0.8, 1.0, 1.3, 4.0})
      EXPECT_LT(error_for_two(eccentricity, 7, step), 1e-13) << step << ' ' << eccentricity;
}

/// Eight bodies at the pericentre, one from the centre, of orbits of all kinds.
struct Passages {
  PackVector place{}, velocity{};
  Passages() {
    place[0] += 1;
    for (std::size_t k = 0; k < pack_size; ++k) velocity[1][k] = std::sqrt(1 + eccentricity[k]);
  }
  double energy(std::size_t k) const {
    return (velocity[0][k] * velocity[0][k] + velocity[1][k] * velocity[1][k]) / 2 -
           1 / std::hypot(place[0][k], place[1][k]);
  }
  double turn(std::size_t k) const {
    return place[0][k] * velocity[1][k] - place[1][k] * velocity[0][k];
  }
  static constexpr double eccentricity[] = {0, 0.5, 0.99, 1, 1.0001, 2, 10, 100};
};

/// Energies and turns must be kept, and the way back lead to the start: whatever the time.
TEST(KeplerMotion, IsFoundForEveryOrbitAndTime) {
  for (const double time : {1e-6, 0.1, 3.0, 50.0, 1e4}) {
    Passages bodies;
    move_on_orbits(Pack{} + 1, time, bodies.place, bodies.velocity);
    for (std::size_t k = 0; k < pack_size; ++k) {
      const double e = Passages::eccentricity[k];
      EXPECT_NEAR(bodies.energy(k), (e - 1) / 2, 1e-13 * (1 + e)) << e << ' ' << time;
      EXPECT_NEAR(bodies.turn(k), std::sqrt(1 + e), 1e-12 * (1 + time)) << e << ' ' << time;
    }
    move_on_orbits(Pack{} + 1, -time, bodies.place, bodies.velocity);
    for (std::size_t k = 0; k < pack_size; ++k)
      EXPECT_NEAR(bodies.place[0][k], 1, 1e-11 * (1 + time)) << Passages::eccentricity[k];
  }
}

TEST(KeplerMotion, IsNotThatOfAnotherPull) {
  Passages bodies;
  move_on_orbits(Pack{} + 1 + 1e-9, 3, bodies.place, bodies.velocity);
  EXPECT_GT(std::abs(bodies.energy(1) - -0.25), 1e-11);
}

TEST(KeplerMotion, IsStraightWhereNothingPulls) {
  Passages bodies;
  move_on_orbits(Pack{}, 4, bodies.place, bodies.velocity);
  EXPECT_EQ(bodies.place[0][0], 1);
  EXPECT_EQ(bodies.place[1][0], 4);
}

/// Two planets of this part of the mass, on orbits a little eccentric and inclined.
MassPoints two_planets(double part) {
  return {1,
          {1, part, 0.5 * part},
          {0, 0, 0, 1, 0, 0, 0, 1.9, 0.1},
          {0, 0, 0, 0, 1.03, 0.02, -0.71, 0.05, 0}};
}

/// Error after 4 time units, about half the inner planet's period, in this many steps.
double error_after(double part, int steps) {
  MassPoints bodies = two_planets(part), exact = two_planets(part);
  WisdomHolman method;
  GaussRadau15 reference;
  take_steps(bodies, method, steps, 4.0 / steps);
  for (double now = 0; 4 - now > 1e-15;) now += reference.advance(exact, now, 4 - now);
  return distance(bodies.position, exact.position);
}

TEST(WisdomHolman, IsOfOrder2) {
  double coarser = error_after(1e-3, 40);
  for (const int steps : {80, 160, 320}) {
    const double error = error_after(1e-3, steps);
    EXPECT_NEAR(std::log2(coarser / error), 2, 0.1);
    coarser = error;
  }
  EXPECT_LT(coarser, 1e-7);
}

TEST(WisdomHolman, ErrsInProportionToThePlanets) {
  EXPECT_NEAR(error_after(1e-3, 80) / error_after(1e-5, 80), 100, 5);
  EXPECT_NEAR(error_after(1e-5, 80) / error_after(1e-7, 80), 100, 1);
}

/// Negative control: a method that does not know Kepler's orbits.
TEST(VelocityVerlet, ErrsWithoutPlanetsToo) {
  MassPoints bodies = two_planets(1e-7), exact = two_planets(1e-7);
  VelocityVerlet method;
  GaussRadau15 reference;
  take_steps(bodies, method, 80, 0.05);
  for (double now = 0; 4 - now > 1e-15;) now += reference.advance(exact, now, 4 - now);
  EXPECT_GT(distance(bodies.position, exact.position), 1e4 * error_after(1e-7, 80));
}

std::vector<double> momentum(const MassPoints& bodies) {
  std::vector<double> sum(3);
  for (std::size_t k = 0; k < bodies.velocity.size(); ++k)
    sum[k % 3] += bodies.mass[k / 3] * bodies.velocity[k];
  return sum;
}

std::vector<double> angular_momentum(const MassPoints& bodies) {
  std::vector<double> sum(3);
  for (std::size_t body = 0; body < bodies.mass.size(); ++body)
    for (std::size_t d = 0; d < 3; ++d) {
      const double *x = &bodies.position[3 * body], *v = &bodies.velocity[3 * body];
      const std::size_t a = (d + 1) % 3, b = (d + 2) % 3;
      sum[d] += bodies.mass[body] * (x[a] * v[b] - x[b] * v[a]);
    }
  return sum;
}

TEST(WisdomHolman, KeepsTheEnergyInBoundsOverManyOrbits) {
  MassPoints bodies = two_planets(1e-4);
  WisdomHolman method;
  const long double start = energy(bodies);
  const auto momentum_then = momentum(bodies), turn_then = angular_momentum(bodies);
  std::vector<double> errors;
  for (int piece = 0; piece < 20; ++piece) {
    double worst = 0;
    for (int k = 0; k < 1000; ++k) {
      take_steps(bodies, method, 20, 0.3);
      worst = std::max(worst, static_cast<double>(std::abs((energy(bodies) - start) / start)));
    }
    errors.push_back(worst);
  }
  EXPECT_LT(std::ranges::max(errors), 3e-6);
  EXPECT_LT(errors.back(), 1.5 * errors.front());  // after nearly 20 000 orbits
  EXPECT_LT(distance(momentum(bodies), momentum_then), 1e-15);
  EXPECT_LT(distance(angular_momentum(bodies), turn_then), 1e-14);
}

TEST(WisdomHolman, FollowsThePlanets) {
  MassPoints bodies = giants();
  WisdomHolman method;
  const long double start = energy(bodies);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    take_steps(bodies, method, 5, 40);
    worst = std::max(worst, static_cast<double>(std::abs((energy(bodies) - start) / start)));
  }
  EXPECT_LT(worst, 3e-7);
  EXPECT_GT(worst, 1e-8);  // it is of order 2, after all
  EXPECT_EQ(bodies.evaluations, 0);
}

/// The giants with a particle within Jupiter's orbit.
MassPoints with_a_particle() {
  MassPoints start = giants();
  start.mass.push_back(0);
  start.position.insert(start.position.end(), {2, 0, 0.1});
  start.velocity.insert(start.velocity.end(), {0, 0.012, 0});
  return start.copy();
}

TEST(WisdomHolman, MovesTestParticlesThatHaveNoEffect) {
  MassPoints bodies = giants(), more = with_a_particle(), exact = with_a_particle();
  WisdomHolman first, second;
  GaussRadau15 reference;
  take_steps(bodies, first, 200, 10);
  take_steps(more, second, 200, 10);
  for (double now = 0; now < 2000;) now += reference.advance(exact, now, 2000 - now);
  for (std::size_t k = 0; k < bodies.position.size(); ++k)
    EXPECT_NEAR(more.position[k], bodies.position[k], 1e-13);
  EXPECT_LT(distance(more.position, exact.position), 1e-4);
  EXPECT_GT(distance(more.position, with_a_particle().position), 1);
}

/// A Sun, two heavy planets and eighteen light ones: more than fill two packs of lanes.
MassPoints many_planets() {
  MassPoints start = two_planets(1e-3);
  for (int k = 0; k < 18; ++k) {
    const double a = 3 + 0.5 * k, angle = 2.4 * k;
    start.mass.push_back(1e-6 * (k % 3));
    start.position.insert(start.position.end(), {a * std::cos(angle), a * std::sin(angle), 0});
    start.velocity.insert(start.velocity.end(),
                          {-std::sin(angle) / std::sqrt(a), std::cos(angle) / std::sqrt(a), 0});
  }
  return start.copy();
}

TEST(WisdomHolman, MovesAnyNumberOfBodies) {
  const auto error = [](int steps) {
    MassPoints bodies = many_planets(), exact = many_planets();
    WisdomHolman method;
    GaussRadau15 reference;
    take_steps(bodies, method, steps, 4.0 / steps);
    for (double now = 0; 4 - now > 1e-15;) now += reference.advance(exact, now, 4 - now);
    return distance(bodies.position, exact.position);
  };
  const double coarse = error(100), fine = error(200);
  EXPECT_LT(fine, 1e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

/// Places after ten steps of `first` and ten of what `next` makes of it.
template <class Next>
std::vector<double> after_a_restart(Next next) {
  MassPoints bodies = giants();
  WisdomHolman first;
  take_steps(bodies, first, 10, 40);
  WisdomHolman second = next(first, bodies);
  take_steps(bodies, second, 10, 40);
  return bodies.position;
}

TEST(WisdomHolman, GoesOnFromItsMemoryWithTheSameBits) {
  const auto straight = after_a_restart([](WisdomHolman& used, MassPoints&) { return used; });
  const auto recalled = after_a_restart([](WisdomHolman& used, MassPoints&) {
    WisdomHolman fresh;
    fresh.recall(used.memory());
    return fresh;
  });
  const auto forgotten = after_a_restart([](WisdomHolman&, MassPoints&) { return WisdomHolman(); });
  EXPECT_EQ(recalled, straight);
  EXPECT_NE(forgotten, straight);
  EXPECT_TRUE(WisdomHolman().memory().empty());
}

TEST(WisdomHolman, TakesUpAStateThatWasChanged) {
  const auto push = [](MassPoints& bodies) {
    bodies.velocity[4] += 1e-6;
    bodies.position[8] += 1e-3;
  };
  const auto used = after_a_restart([&](WisdomHolman& used, MassPoints& bodies) {
    push(bodies);
    return used;
  });
  const auto fresh = after_a_restart([&](WisdomHolman&, MassPoints& bodies) {
    push(bodies);
    return WisdomHolman();
  });
  EXPECT_EQ(used, fresh);
}

TEST(WisdomHolman, SaysWhatItNeeds) {
  MassPoints bodies = giants();
  EXPECT_EQ(WisdomHolman().missing_in(bodies), "");
  std::swap(bodies.mass[0], bodies.mass[1]);
  EXPECT_THAT(WisdomHolman().missing_in(bodies), testing::HasSubstr("first body"));
  ForcedOscillators oscillators;
  EXPECT_THAT(WisdomHolman().missing_in(oscillators), testing::HasSubstr("point masses"));
}

}  // namespace
}  // namespace mote::test
