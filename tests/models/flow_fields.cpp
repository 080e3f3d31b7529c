// What a weakly compressible flow does away from walls: sound, sums, shifting, the free surface,
// and derivatives by an operator.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/flow_case.hpp"

namespace mote::test {
namespace {

FlowCase periodic_square(double spacing, double width) {
  FlowCase flow = flow_in_a_box(2, spacing, {width, width}, {true, true, false});
  flow.options.free_surface = false;
  flow.options.diffusion = DensityDiffusion::none;
  return flow;
}

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

/// Root mean square distance of the particles to their nearest neighbours' mean, in spacings, and
/// the smallest distance of two.
std::pair<double, double> distances(const WeaklyCompressible<2>& flow, double spacing,
                                    double width) {
  std::vector<double> nearest;
  const Index count = flow.cloud().count();
  for (Index i = 0; i < count; ++i) {
    double least = width;
    for (Index j = 0; j < count; ++j) {
      Vec<2> x = vector_of(flow, "position", i) - vector_of(flow, "position", j);
      for (int d = 0; d < 2; ++d) x[d] -= width * std::round(x[d] / width);
      if (j != i) least = std::min(least, x.norm());
    }
    nearest.push_back(least / spacing);
  }
  const double mean =
      std::accumulate(nearest.begin(), nearest.end(), 0.0) / static_cast<double>(count);
  double spread = 0;
  for (const double distance : nearest) spread += std::pow(distance - mean, 2);
  return {std::sqrt(spread / static_cast<double>(count)), std::ranges::min(nearest)};
}

/// A jittered box that streams through its periodic sides.
std::pair<double, double> distances_after_streaming(double shifting) {
  FlowCase flow = periodic_square(0.1, 1.2);
  flow.options.shifting = shifting;
  flow.velocity = [](const Place&) { return Triple{1}; };
  const auto made = make_flow<2>(in_disorder(flow, 0.25));
  run(*made, 0.2, 100);
  return distances(*made, 0.1, 1.2);
}

TEST(Shifting, MakesParticlesMoreRegular) {
  const auto [spread, closest] = distances_after_streaming(0);  // the negative control
  const auto [shifted_spread, shifted_closest] = distances_after_streaming(1);
  EXPECT_LT(shifted_spread, 0.5 * spread);
  EXPECT_GT(shifted_closest, closest + 0.1);
}

Mat<2> slopes() { return (Mat<2>() << 0.3, -0.8, 0.5, -0.3).finished(); }

/// Particles in disorder in a field u = A x + bend (x^2 + y^2), of linear density, moved by
/// shifting alone: the largest error of the velocity they carry.
std::array<double, 3> error_after_shifting(double bend, double step) {
  FlowCase flow = flow_in_a_box(2, 0.1, {1, 1});
  flow.options.shifting = 1;
  flow.options.free_surface = false;
  const auto velocity = [=](const Vec<2>& x) -> Vec<2> {
    return slopes() * x + bend * x.squaredNorm() * Vec<2>::Ones();
  };
  flow.velocity = [=](const Place& at) {
    const Vec<2> u = velocity({at[0], at[1]});
    return Triple{u[0], u[1]};
  };
  flow.pressure = [](const Place& at) { return 20 * at[0] - 10 * at[1]; };
  const auto made = make_flow<2>(in_disorder(flow, 0.25));
  made->longest_step(0, 0.2);
  const auto before = made->cloud();
  made->end_step(0, step);
  const Index count = made->cloud().count();
  const auto error = [&](Index i) -> Vec<2> {
    return vector_of(*made, "velocity", i) - velocity(vector_of(*made, "position", i));
  };
  // What all gain alike is taken back, so that momentum stays.
  Vec<2> common = Vec<2>::Zero();
  for (Index i = 0; i < count; ++i) common += error(i) / count;
  std::array<double, 3> found{};
  for (Index i = 0; i < count; ++i) {
    const Vec<2> x = vector_of(*made, "position", i);
    const double off = (error(i) - common).norm();
    const double density = 1 + (20 * x[0] - 10 * x[1]) / 100;
    const Vec<2> moved = x - Vec<2>::Map(before.position().data() + std::ptrdiff_t{i} * 2);
    found[0] = std::max(found[0], off);
    found[1] = std::max(found[1], std::abs(made->cloud().values("density")[i] - density));
    found[2] = std::max(found[2], moved.norm());
  }
  return found;
}

TEST(Shifting, LeavesLinearFieldsAsTheyAre) {
  const auto [velocity, density, moved] = error_after_shifting(0, 0.003);
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(velocity, 1e-13);
  EXPECT_LT(density, 1e-13);
}

/// The error of a field that bends goes with the way times the spacing at least: it is of first
/// order in the shift, and not 0 (a negative control of the test above).
TEST(Shifting, CarriesFieldsThatBendAsFarAsTheirSlopes) {
  const auto coarse = error_after_shifting(1, 2e-4), fine = error_after_shifting(1, 1e-4);
  EXPECT_GT(fine[0], 1e-8);
  EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 1, 0.2);
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
