// What a weakly compressible flow does away from walls: sound, sums, the free surface, and
// derivatives by an operator.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/flow_case.hpp"

namespace mote::test {
namespace {

/// A pulse that travels along x: p = rho c u in the direction of travel.
FlowCase pulse(double sound_speed) {
  FlowCase flow = flow_in_a_box(2, 0.025, {3, 0.15}, {true, true, false});
  flow.options.sound_speed = sound_speed;
  flow.options.free_surface = false;
  flow.options.diffusion = DensityDiffusion::none;
  const auto velocity = [](double x) { return 1e-4 * std::exp(-std::pow((x - 1) / 0.3, 2)); };
  flow.velocity = [=](const Place& at) { return Triple{velocity(at[0])}; };
  flow.pressure = [=](const Place& at) { return sound_speed * velocity(at[0]); };
  return flow;
}

/// Middle of the pulse, by the pressure as a weight.
double middle_of_pulse(WeaklyCompressible<2>& flow) {
  flow.complete_fields();
  double sum = 0, moment = 0;
  for (Index i = 0; i < flow.cloud().count(); ++i) {
    const double pressure = flow.cloud().values("pressure")[i];
    sum += pressure;
    moment += pressure * flow.cloud().position()[static_cast<std::size_t>(i) * 2];
  }
  return moment / sum;
}

TEST(Sound, TravelsAtItsSpeed) {
  const double speed = 10, time = 0.1;
  const auto flow = make_flow<2>(pulse(speed));
  const double start = middle_of_pulse(*flow);
  EXPECT_NEAR(start, 1, 1e-4);
  run(*flow, time, 150);
  EXPECT_NEAR((middle_of_pulse(*flow) - start) / time, speed, 0.02 * speed);
}

/// Negative control: no other speed passes for it.
TEST(Sound, DoesNotTravelAtAnotherSpeed) {
  const double time = 0.1;
  const auto flow = make_flow<2>(pulse(9.5));
  run(*flow, time, 150);
  EXPECT_GT(std::abs((middle_of_pulse(*flow) - 1) / time - 10), 0.02 * 10);
}

TEST(SummationDensity, IsTheSumOverTheLattice) {
  FlowCase flow = periodic_square(0.1, 1);
  flow.options.density = 3;
  flow.options.density_form = FluidDensity::summation;
  const auto made = make_flow<2>(flow);
  update_rates(*made);
  double sum = 0;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      sum += WendlandC2<2>::value(std::hypot(x, y) / flow.smoothing_length) /
             std::pow(flow.smoothing_length, 2);
  for (const double density : made->cloud().values("density")) EXPECT_NEAR(density, 3 * sum, 1e-13);
  EXPECT_NEAR(sum, 1, 0.01);
  EXPECT_GT(std::abs(sum - 1), 1e-6);  // negative control: not the density at rest
}

TEST(FreeSurface, IsFlaggedInATankAndNothingInsideIs) {
  const double spacing = 0.05, gravity = 2;
  FlowCase flow = flow_in_a_box(2, spacing, {1, 0.5});
  flow.options.sound_speed = 20;
  flow.options.body_force.gravity = {0, -gravity};
  flow.pressure = [=](const Place& at) { return gravity * (0.5 - at[1]); };
  with_wall(flow, 0, false);
  with_wall(flow, 0, true);
  with_wall(flow, 1, false);
  const auto tank = make_flow<2>(flow);
  tank->complete_snapshot();
  for (const Index i : fluid_of(*tank)) {
    const double depth = 0.5 - vector_of(*tank, "position", i)[1];
    const double flag = tank->cloud().values("surface")[i];
    if (depth < spacing) {
      EXPECT_EQ(flag, 1) << depth;
    } else if (depth > 3 * spacing) {
      EXPECT_EQ(flag, 0) << depth;
    }
  }
  // Negative control: with a lid there is none.
  with_wall(flow, 1, true);
  const auto closed = make_flow<2>(flow);
  closed->complete_snapshot();
  EXPECT_EQ(std::ranges::max(closed->cloud().values("surface")), 0);
}

/// A patch in disorder with linear pressure and parabolic velocity.
FlowCase patch(Derivatives derivatives) {
  FlowCase flow = flow_in_a_box(2, 0.1, {1, 1});
  flow.options.diffusion = DensityDiffusion::none;
  flow.options.pressure = flow.options.divergence = derivatives;
  flow.pressure = [](const Place& at) { return 2 * at[0] - 3 * at[1]; };
  return in_disorder(flow, 0.2);
}

double error_of_acceleration(WeaklyCompressible<2>& flow, const Vec<2>& force) {
  update_rates(flow);
  return most_in_fluid(flow, [&](Index i) {
    return (acceleration_of(flow, i) * flow.cloud().values("density")[i] - force).norm();
  });
}

TEST(OperatorTerms, AreExactForALinearPressure) {
  const auto by_operator = make_flow<2>(patch(Derivatives::by_operator));
  EXPECT_LT(error_of_acceleration(*by_operator, {-2, 3}), 1e-12);
  const auto by_pairs = make_flow<2>(patch(Derivatives::pairs));  // the negative control
  EXPECT_GT(error_of_acceleration(*by_pairs, {-2, 3}), 0.1);
}

TEST(OperatorTerms, AreExactForALinearVelocity) {
  FlowCase given = patch(Derivatives::by_operator);
  given.velocity = [](const Place& at) { return Triple{0.3 * at[0] + at[1], 0.4 * at[1]}; };
  const auto flow = make_flow<2>(given);
  update_rates(*flow);
  const auto rate = flow->kicked()[1].rate;
  EXPECT_LT(most_in_fluid(*flow,
                          [&](Index i) {
                            return std::abs(rate[i] / flow->cloud().values("density")[i] + 0.7);
                          }),
            1e-12);
}

TEST(OperatorTerms, AreExactForAParabolicVelocity) {
  FlowCase given = patch(Derivatives::by_operator);
  given.options.viscosity = Viscosity::by_operator;
  given.options.kinematic_viscosity = 0.1;
  given.velocity = [](const Place& at) { return Triple{at[1] * at[1], 3 * at[0] * at[1]}; };
  given.pressure = [](const Place&) { return 0.0; };
  const auto flow = make_flow<2>(given);
  EXPECT_LT(error_of_acceleration(*flow, {0.2, 0}), 1e-11);
}

}  // namespace
}  // namespace mote::test
