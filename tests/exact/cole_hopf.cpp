#include "mote/exact/cole_hopf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burgers_reference.hpp"

namespace mote::test {
namespace {

/// (88) of Isshiki (2014) with L = 4, and the same in 50 digits.
double flat_slope_flat(double x) { return std::clamp(-(2.0 / 4) * (x - 2), -0.5, 0.5); }
Corners flat_slope_flat_corners(double first = 1) {
  return {{-100, first, 3, 100}, {0.5, 0.5, -0.5, -0.5}};
}

struct Difference {
  double velocity, slope;
};

struct Case {
  std::function<double(double)> start;
  std::function<Big(Big, double time)> reference;
  double viscosity, time;
  std::vector<double> places;
};

/// The largest differences from the reference. That of the slope is relative to the largest slope
/// a layer between -U and U of this viscosity can have, U^2/(2 nu), or 1.
Difference difference(const Case& c) {
  ColeHopf solution(c.start, 0, 4, c.viscosity);
  const auto [lower, upper] = std::ranges::minmax(c.places);
  solution.cover(lower, upper, c.time);
  Difference largest{};
  const double steepest =
      std::max(1.0, solution.fastest() * solution.fastest() / (2 * c.viscosity));
  for (const double x : c.places) {
    const auto reference =
        differentiated([&](const Big& at) { return c.reference(at, c.time); }, x);
    const auto [velocity, slope] = solution(x, c.time);
    const double off = static_cast<double>(abs(velocity - reference.velocity));
    const double slope_off = static_cast<double>(abs(slope - reference.slope)) / steepest;
    largest.velocity = std::max(largest.velocity, off);
    largest.slope = std::max(largest.slope, slope_off);
  }
  return largest;
}

void expect_agreement(const Case& c, double most = 1e-12) {
  const auto [velocity, slope] = difference(c);
  EXPECT_LT(velocity, most) << "nu = " << c.viscosity << ", t = " << c.time;
  EXPECT_LT(slope, 1e-12) << "nu = " << c.viscosity << ", t = " << c.time;
}

Case slope_case(double viscosity, double time, std::vector<double> places, double first = 1) {
  return {flat_slope_flat,
          [=](const Big& x, double t) {
            return velocity_from_corners(flat_slope_flat_corners(first), x, t, viscosity);
          },
          viscosity, time, std::move(places)};
}

TEST(ColeHopf, FlatSlopeFlatBeforeAndAfterTheShock) {
  for (const double time : {0.5, 2.0, 2.5, 10.0})
    expect_agreement(slope_case(0.02, time, {-3, 0.9, 1.7, 1.99, 2, 2.001, 2.3, 3.4, 9}));
}

TEST(ColeHopf, SteepLayer) {
  for (const double time : {1.9, 2.5, 4.0})
    expect_agreement(slope_case(1e-4, time, {0.3, 1.95, 1.9998, 2, 2.0001, 2.0005, 2.002, 2.1}));
}

TEST(ColeHopf, AtKinksSoonAfterTheStart) {
  for (const double viscosity : {0.02, 1e-4})
    for (const double time : {1e-6, 1e-3})
      expect_agreement(slope_case(viscosity, time,
                                  {0.5, 1 - 1e-4, 1, std::nextafter(1, 2), 1 + 1e-5, 2, 3, 3.001}));
}

TEST(ColeHopf, ViscosityOfTheOrderOfOne) {
  expect_agreement(slope_case(3, 0.7, {-4, 0, 1, 2.2, 7}));
}

/// The reference is not this agreeable: a corner that is off by 1e-9 shows.
TEST(ColeHopf, AnotherStartIsFarther) {
  EXPECT_GT(difference(slope_case(0.02, 0.5, {0.9, 1.1, 1.7}, 1 + 1e-9)).velocity, 1e-11);
}

/// The jump is where no number is round; places are relative to it.
Case jump_case(double left, double right, double viscosity, double time,
               std::vector<double> places) {
  const double at = 1.3;
  for (double& place : places) place += at;
  return {
      [=](double x) { return x < at ? left : right; },
      [=](const Big& x, double t) { return velocity_from_jump(left, right, x - at, t, viscosity); },
      viscosity, time, std::move(places)};
}

/// In the fan of a jump that opens all depends on the two sides of the jump, to the last place.
TEST(ColeHopf, Jumps) {
  for (const double viscosity : {0.02, 1e-3, 8e-5})
    for (const double time : {1e-6, 0.1, 3.0}) {
      expect_agreement(jump_case(1, -0.25, viscosity, time, {-0.4, -1e-4, 0, 1e-5, 1.125, 2}));
      expect_agreement(jump_case(-0.5, 1, viscosity, time, {-0.4, -1e-4, 0, 1e-5, 0.7, 1.5, 3}),
                       1e-14);
    }
}

Case sine_case(double viscosity, double time, double phase = 0) {
  return {[](double x) { return -std::sin(std::numbers::pi * x); },
          [=](const Big& x, double t) { return velocity_from_sine(x + phase, t, viscosity); },
          viscosity,
          time,
          {-0.9, -0.01, 0, 0.02, 1, 2.004}};
}

TEST(ColeHopf, Sine) {
  for (const double viscosity : {0.1, 0.02, 0.01})
    for (const double time : {0.25, 1.0, 3.0}) expect_agreement(sine_case(viscosity, time));
  // Before the shock the series cancels to exp(-100) at this viscosity.
  for (const double time : {1.0, 3.0}) expect_agreement(sine_case(0.01 / std::numbers::pi, time));
}

TEST(ColeHopf, ShiftedSineIsFarther) {
  EXPECT_GT(difference(sine_case(0.02, 1, 1e-9)).velocity, 1e-10);
}

/// The layer that the two flat parts press together is  u = -tanh((x - 2)/(4 nu))/2, what else
/// there is being exp(-1/nu). A place is known to its rounding, 2e-16, and the start to as much.
TEST(ColeHopf, LayerAsThinAsAPlaceIsKnown) {
  for (const double viscosity : {1e-4, 1e-6, 1e-8}) {
    ColeHopf solution(flat_slope_flat, 0, 4, viscosity);
    solution.cover(0, 4, 4);
    for (const double away : {-8.0, -1.0, -0.3, 0.0, 0.5, 2.0, 20.0}) {
      const double x = 2 + away * viscosity, s = (x - 2) / (4 * viscosity);
      const double slope = -1 / (8 * viscosity * std::cosh(s) * std::cosh(s));
      const auto [u, u_x] = solution(x, 4);
      EXPECT_NEAR(u, -0.5 * std::tanh(s), 1e-15 + 1e-15 / viscosity);
      EXPECT_NEAR(u_x, slope, 1e-15 / (viscosity * viscosity));
    }
  }
}

/// A straight line stays one, whatever the viscosity; a part of one, up to exp(-1e-3/nu).
TEST(ColeHopf, StraightPartBeforeTheShock) {
  for (const double viscosity : {1e-5, 1e-8}) {
    ColeHopf solution(flat_slope_flat, 0, 4, viscosity);
    solution.cover(0, 4, 1);
    for (const double x : {1.7, 2.0, 2.1}) {
      const auto [u, u_x] = solution(x, 1);
      EXPECT_NEAR(u, -(x - 2), 1e-14);
      EXPECT_NEAR(u_x, -1, 1e-11);
    }
  }
}

}  // namespace
}  // namespace mote::test
