#include "mote/integrators/gauss_radau_15.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mote/integrators/runge_kutta_4.hpp"
#include "point_masses.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

/// What the weights make of s^power, less its integral, in units of the last place of 1.
long double quadrature_error(const gauss_radau::Row& node, const gauss_radau::Weights& weights,
                             int power, long double integral) {
  long double sum = 0;
  for (std::size_t k = 0; k < gauss_radau::nodes; ++k)
    sum += (static_cast<long double>(weights.weight[k]) + weights.rest[k]) *
           std::pow(static_cast<long double>(node[k]), static_cast<long double>(power));
  return std::abs(sum - integral) / 0x1p-53L;
}

/// Up to degree 7, that of the polynomials, far below rounding; up to twice that by the choice of
/// the nodes, to the rounding of these.
bool is_gauss_radau(const gauss_radau::Row& node) {
  for (int power = 1; power <= 14; ++power) {
    const long double limit = power <= 7 ? 0.01L : 1;
    if (!(quadrature_error(node, gauss_radau::to_velocity, power, 1.0L / (power + 1)) < limit))
      return false;
  }
  return true;
}

TEST(GaussRadauTables, IntegrateAllThatTheyCan) {
  using namespace gauss_radau;
  EXPECT_TRUE(is_gauss_radau(node));
  for (int power = 1; power <= 7; ++power)
    EXPECT_LT(quadrature_error(node, to_place, power, 1.0L / ((power + 1) * (power + 2))), 0.01);
  EXPECT_GT(quadrature_error(node, to_velocity, 15, 1.0L / 16), 1e4);  // one degree more
}

TEST(GaussRadauTables, BelongToTheNodesToTheLastBit) {
  gauss_radau::Row node = gauss_radau::node;
  node[3] = std::nextafter(node[3], 1);
  EXPECT_FALSE(is_gauss_radau(node));
}

/// Root mean square, over points of an orbit, of the error of one step, against eight short ones.
double error_of_a_step(double length) {
  constexpr int points = 24;
  MassPoints orbit = kepler(0.1);
  GaussRadau15 along;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    along.advance_one_step(orbit, 0, 2 * pi / points);
    MassPoints once = orbit.copy(), often = orbit.copy();
    GaussRadau15 one, eight;
    one.advance_one_step(once, 0, length);
    for (int part = 0; part < 8; ++part) eight.advance_one_step(often, 0, length / 8);
    sum += std::pow(distance(once.position, often.position), 2) +
           std::pow(distance(once.velocity, often.velocity), 2);
  }
  return std::sqrt(sum / points);
}

/// One step errs by step^(order + 1). Errors are 1e-13 to 1e-15: shorter steps see rounding alone.
testing::AssertionResult has_order(int order) {
  double longer = error_of_a_step(0.9), last = 0.9;
  for (const double step : {0.8, 0.7}) {
    const double error = error_of_a_step(step);
    const double observed = std::log(longer / error) / std::log(last / step) - 1;
    if (!(std::abs(observed - order) < 0.4)) return testing::AssertionFailure() << observed;
    longer = error, last = step;
  }
  if (longer < 1e-12 * std::pow(last, order + 1)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << longer;
}

TEST(GaussRadau15, IsOfOrder15) {
  EXPECT_TRUE(has_order(15));
  EXPECT_FALSE(has_order(14));
  EXPECT_FALSE(has_order(16));
}

/// Error after a time of 6 in this many steps, of a system that may see another time.
double forced_error(int steps, double clock) {
  ForcedOscillators system;
  GaussRadau15 method;
  for (int k = 0; k < steps; ++k)
    method.advance_one_step(system, clock * k * 6 / steps, 6.0 / steps);
  return system.error(6);
}

TEST(GaussRadau15, FollowsForcesThatChangeWithTime) {
  EXPECT_LT(forced_error(7, 1), 2e-14);
  EXPECT_GT(forced_error(7, 0.999), 1e-5);
}

TEST(GaussRadau15, NeedsAccelerationsWithoutVelocities) {
  MassPoints bodies = giants();
  EXPECT_EQ(GaussRadau15().missing_in(bodies), "");
  DampedOscillator damped;
  EXPECT_THAT(GaussRadau15().missing_in(damped), testing::HasSubstr("time and places alone"));
  for (int k = 0; k < 20; ++k) GaussRadau15().advance_one_step(damped, 0, 0.05);
  EXPECT_GT(damped.error(1), 1e-4);  // for good reason
}

/// Steps that the method chooses itself, up to this time. Returns how many.
int run(MassPoints& bodies, Integrator& method, double time) {
  int steps = 0;
  for (double now = 0; time - now > 1e-15 * time; ++steps)
    now += method.advance(bodies, now, time - now);
  return steps;
}

struct Round {
  double error;
  int evaluations;
};

/// Where Kepler's orbit is after a period.
Round once_round(double eccentricity, double tolerance) {
  MassPoints bodies = kepler(eccentricity);
  const std::vector<double> start = bodies.position;
  GaussRadau15 method;
  method.tolerate(tolerance);
  run(bodies, method, 2 * pi);
  return {distance(bodies.position, start), bodies.evaluations};
}

TEST(GaussRadau15, GoesRoundAnEccentricOrbitToRoundingInFewEvaluations) {
  const Round round = once_round(0.9, GaussRadau15::default_tolerance);
  EXPECT_LT(round.error, 1e-13);
  EXPECT_LT(round.evaluations, 1400);
  const Round coarse = once_round(0.9, 1e-4);
  EXPECT_GT(coarse.error, 1e-11);
  EXPECT_LT(coarse.evaluations, round.evaluations);
}

TEST(GaussRadau15, GoesRoundOrbitsOfAnyEccentricity) {
  EXPECT_LT(once_round(0, GaussRadau15::default_tolerance).error, 1e-13);
  EXPECT_LT(once_round(0.5, GaussRadau15::default_tolerance).error, 1e-13);
  EXPECT_LT(once_round(0.99, GaussRadau15::default_tolerance).error, 1e-11);
}

/// A fall from almost at rest tells nothing of the pericentre that it comes to.
TEST(GaussRadau15, ShortensItsStepsInAFall) {
  MassPoints bodies = binary(0);
  bodies.velocity = {0, -0.004, 0, 0, 0.006, 0};
  const long double start = energy(bodies);
  GaussRadau15 method;
  run(bodies, method, 3);  // nearly three periods of almost a straight line
  EXPECT_LT(std::abs((energy(bodies) - start) / start), 1e-12);
}

/// Largest energy error of each of some pieces of a long run, relative.
template <class Advance>
std::vector<double> energy_errors(MassPoints& bodies, int pieces, Advance advance) {
  const long double start = energy(bodies);
  std::vector<double> errors;
  for (int piece = 0; piece < pieces; ++piece) {
    advance();
    errors.push_back(static_cast<double>(std::abs((energy(bodies) - start) / start)));
  }
  return errors;
}

/// Brouwer's law: unbiased roundings of n steps add up as their root. A bias of a thousandth of a
/// last place a step would show.
bool is_rounding_alone(const std::vector<double>& errors, int steps) {
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double so_far = static_cast<double>(steps) * static_cast<double>(k + 1) /
                          static_cast<double>(errors.size());
    if (!(errors[k] <= 1e-15 + 0.3 * 0x1p-53 * std::sqrt(so_far))) return false;
  }
  return true;
}

TEST(GaussRadau15, KeepsTheEnergyOfManyPeriodsAsRoundingAllows) {
  MassPoints bodies = binary(0.3);
  GaussRadau15 method;
  method.tolerate(1e-9);
  int steps = 0;
  const auto errors =
      energy_errors(bodies, 20, [&] { steps += run(bodies, method, 100 * 2 * pi); });
  EXPECT_GT(steps, 50'000);
  EXPECT_TRUE(is_rounding_alone(errors, steps)) << testing::PrintToString(errors);

  MassPoints again = binary(0.3);
  RungeKutta4 drifting;
  const auto drift = energy_errors(again, 4, [&] {
    for (int k = 0; k < 1000; ++k) drifting.advance_one_step(again, 0, 2 * pi / 500);
  });
  EXPECT_FALSE(is_rounding_alone(drift, 4000));
}

TEST(GaussRadau15, KeepsTheEnergyOfThePlanets) {
  MassPoints bodies = giants();
  GaussRadau15 method;
  const auto errors = energy_errors(bodies, 10, [&] { run(bodies, method, 36525); });
  EXPECT_LT(std::ranges::max(errors), 5e-15);
  EXPECT_LT(bodies.evaluations, 40'000);
  method.tolerate(1e-3);  // negative control
  EXPECT_GT(energy_errors(bodies, 1, [&] { run(bodies, method, 365250); }).front(), 1e-13);
}

/// The place on Kepler's orbit of half axis 1 and mean anomaly `time`, from the pericentre.
std::vector<double> place_on_orbit(double eccentricity, double time) {
  double anomaly = time;
  for (int k = 0; k < 100; ++k) anomaly = time + eccentricity * std::sin(anomaly);
  return {std::cos(anomaly) - eccentricity,
          std::sqrt(1 - eccentricity * eccentricity) * std::sin(anomaly)};
}

TEST(GaussRadau15, HasAPathAsGoodAsItsSteps) {
  MassPoints bodies = kepler(0.3);
  GaussRadau15 method;
  const auto off_orbit = [&](double time) {
    const auto place = place_on_orbit(0.3, time);
    return std::hypot(bodies.position[3] - place[0], bodies.position[4] - place[1]);
  };
  double before = 0;
  for (int k = 0; k < 20; ++k) {
    const double step = method.advance(bodies, before, 10);
    const std::vector<double> end = bodies.position, speed = bodies.velocity;
    for (const double part : {0.0, 0.1, 0.37, 0.5, 0.9}) {
      method.go_along_path(bodies, part);
      EXPECT_LT(off_orbit(before + part * step), 5e-14);
      EXPECT_GT(off_orbit(before + (part + 1e-6) * step), 1e-9);
    }
    method.go_along_path(bodies, 0.999999);
    EXPECT_LT(distance(bodies.velocity, speed), 1e-5);
    method.go_along_path(bodies, 1);
    EXPECT_EQ(bodies.position, end);
    EXPECT_EQ(bodies.velocity, speed);
    before += step;
  }
}

/// Places after ten steps of `first` and ten of what `next` makes of it.
template <class Next>
std::vector<double> after_a_restart(Next next) {
  MassPoints bodies = giants();
  GaussRadau15 first;
  for (int k = 0; k < 10; ++k) first.advance(bodies, 0, 1000);
  GaussRadau15 second = next(first, bodies);
  for (int k = 0; k < 10; ++k) second.advance(bodies, 0, 1000);
  return bodies.position;
}

TEST(GaussRadau15, GoesOnFromItsMemoryWithTheSameBits) {
  const auto straight = after_a_restart([](GaussRadau15& used, MassPoints&) { return used; });
  const auto recalled = after_a_restart([](GaussRadau15& used, MassPoints&) {
    GaussRadau15 fresh;
    fresh.recall(used.memory());
    return fresh;
  });
  const auto forgotten = after_a_restart([](GaussRadau15&, MassPoints&) { return GaussRadau15(); });
  EXPECT_EQ(recalled, straight);
  EXPECT_NE(forgotten, straight);
  EXPECT_TRUE(GaussRadau15().memory().empty());
}

TEST(GaussRadau15, StartsAfreshWhereTheStateWasChanged) {
  const auto push = [](MassPoints& bodies) { bodies.velocity[4] += 1e-9; };
  const auto used = after_a_restart([&](GaussRadau15& used, MassPoints& bodies) {
    push(bodies);
    return used;
  });
  const auto fresh = after_a_restart([&](GaussRadau15&, MassPoints& bodies) {
    push(bodies);
    return GaussRadau15();
  });
  EXPECT_EQ(used, fresh);
}

}  // namespace
}  // namespace mote::test
