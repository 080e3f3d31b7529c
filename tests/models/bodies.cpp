#include "mote/models/bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mote/integrators/all.hpp"
#include "mote/models/lagrangian_radii.hpp"
#include "support/bodies_case.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

/// Two bodies about their centre of mass, one apart; they start at rest or with the speed of an
/// orbit times this factor.
BodiesOptions pair_of_bodies(double factor) {
  const double speed = factor * std::sqrt(3.0);  // relative: G (m1 + m2)/d = 3
  return {.masses = {{1, {-2.0 / 3, 0, 0}, {0, -2.0 / 3 * speed, 0}},
                     {2, {1.0 / 3, 0, 0}, {0, 1.0 / 3 * speed, 0}}}};
}

/// Largest difference from the literal sum of -G m x/r^D with the spread mass (r^2 + 5/2 s^2) of
/// the algebraic core of order 2, or of points with s = 0.
template <int D>
double acceleration_error(const Bodies<D>& bodies, double constant, double size) {
  const auto place = [&](Index i) { return vector_of(bodies, "position", i); };
  double worst = 0, largest = 0;
  for (Index i = 0; i < bodies.cloud().count(); ++i) {
    Vec<D> sum = Vec<D>::Zero();
    for (Index j = 0; j < bodies.cloud().count(); ++j) {
      if (i == j) continue;
      const Vec<D> x = place(i) - place(j);
      const double r2 = x.squaredNorm(), s2 = size * size;
      const double influence =
          D == 2 ? (r2 + 2 * s2) / std::pow(r2 + s2, 2) : (r2 + 2.5 * s2) / std::pow(r2 + s2, 2.5);
      sum -= constant * bodies.cloud().values("mass")[static_cast<std::size_t>(j)] * influence * x;
    }
    worst = std::max(worst, (vector_of(bodies, "acceleration", i) - sum).norm());
    largest = std::max(largest, sum.norm());
  }
  return worst / largest;
}

template <int D>
void expect_literal_sums() {
  BodiesOptions options{.gravitational_constant = 0.7, .clusters = {uniform_ball(300)}};
  options.masses = {{0.5, std::vector<double>(D, 1.5), {}}};
  EXPECT_LT(acceleration_error(*make_bodies<D>(options), 0.7, 0), 1e-13);
  options.sum = "multipole";
  options.tolerance = 1e-6;
  EXPECT_LT(acceleration_error(*make_bodies<D>(options), 0.7, 0), 1e-6);
  options.core = "algebraic.2";
  options.core_size = 0.1;
  EXPECT_LT(acceleration_error(*make_bodies<D>(options), 0.7, 0.1), 1e-6);
  EXPECT_GT(acceleration_error(*make_bodies<D>(options), 0.7, 0.11), 1e-3);  // negative control
}

TEST(Bodies, AccelerateByTheLiteralSumInThePlane) { expect_literal_sums<2>(); }
TEST(Bodies, AccelerateByTheLiteralSumInSpace) { expect_literal_sums<3>(); }

/// How far the pair is from where it started, after one period.
template <class Method>
double orbit_error(double factor, int steps) {
  const auto bodies = make_bodies<3>(pair_of_bodies(factor));
  const Vec<3> start = vector_of(*bodies, "position", 0);
  // vis viva: 1/a = 2/d - v^2/(G m); Kepler: T = 2 pi sqrt(a^3/(G m))
  const double axis = 1 / (2 - factor * factor);
  const double period = 2 * pi * std::sqrt(axis * axis * axis / 3);
  take_steps(*bodies, Method(), steps, period / steps);
  return (vector_of(*bodies, "position", 0) - start).norm();
}

TEST(Bodies, ReturnAfterThePeriodOfACircleToTheOrderOfTheIntegrator) {
  const double verlet[] = {orbit_error<VelocityVerlet>(1, 100),
                           orbit_error<VelocityVerlet>(1, 200)};
  EXPECT_NEAR(std::log2(verlet[0] / verlet[1]), 2, 0.05);
  const double runge_kutta[] = {orbit_error<RungeKutta4>(1, 400), orbit_error<RungeKutta4>(1, 800)};
  EXPECT_NEAR(std::log2(runge_kutta[0] / runge_kutta[1]), 4, 0.1);
}

TEST(Bodies, ReturnAfterThePeriodOfAnEllipse) {
  EXPECT_LT(orbit_error<RungeKutta4>(0.8, 4000), 1e-9);
  EXPECT_LT(orbit_error<RungeKutta4>(1.2, 4000), 1e-9);
}

/// Negative control: a circle's period is not that of an ellipse.
TEST(Bodies, ReturnNotAfterAnotherPeriod) {
  const auto bodies = make_bodies<3>(pair_of_bodies(0.9));
  const Vec<3> start = vector_of(*bodies, "position", 0);
  take_steps(*bodies, RungeKutta4(), 1000, 2 * pi / std::sqrt(3.0) / 1000);
  EXPECT_GT((vector_of(*bodies, "position", 0) - start).norm(), 0.1);
}

/// Kepler's ellipse: the furthest point is at a (1 + e) after half a period, with the speed there.
TEST(Bodies, FollowKeplersEllipse) {
  const auto bodies = make_bodies<3>(pair_of_bodies(0.8));
  const double axis = 1 / (2 - 0.64), period = 2 * pi * std::sqrt(axis * axis * axis / 3);
  take_steps(*bodies, RungeKutta4(), 2000, period / 4000);
  EXPECT_NEAR(told(*bodies, "separation"), 2 * axis - 1, 1e-10);
  EXPECT_NEAR((vector_of(*bodies, "velocity", 1) - vector_of(*bodies, "velocity", 0)).norm(),
              0.8 * std::sqrt(3.0) / (2 * axis - 1), 1e-9);
}

TEST(Bodies, KeepEnergyMomentumAndAngularMomentum) {
  const auto start_of = [](BodiesOptions options) {
    options.clusters.front().velocity = {0.3, -0.2, 0.1};
    options.core = "gauss";
    options.core_size = 0.1;
    return make_bodies<3>(options);
  };
  const auto bodies = start_of({.clusters = {plummer(400)}});
  const auto start = bodies->conserved();
  take_steps(*bodies, VelocityVerlet(), 100, 0.02);
  const auto end = bodies->conserved();
  EXPECT_LT(drift_of("energy", start, end), 2e-5);
  for (const char* axis : {"x", "y", "z"}) {
    EXPECT_LT(drift_of(std::string("momentum_") + axis, start, end), 1e-14);
    EXPECT_LT(drift_of(std::string("angular_momentum_") + axis, start, end), 1e-13);
  }
  take_steps(*bodies, ForwardEuler(), 100, 0.02);  // negative control
  EXPECT_GT(drift_of("energy", start, bodies->conserved()), 1e-4);
}

TEST(Bodies, LastAPlaneWorldTheEnergyOfLogarithms) {
  const auto bodies = make_bodies<2>(
      {.gravitational_constant = 2, .masses = {{1, {0, 0}, {}}, {3, {0, 4}, {0.5, 0}}}});
  EXPECT_NEAR(told(*bodies, "energy"), 2 * 3 * std::log(4) + 0.5 * 3 * 0.25, 1e-13);
  EXPECT_NEAR(told(*bodies, "angular_momentum"), -6, 1e-14);
}

TEST(Bodies, AskForStepsByTheirSofteningOrTheirDistance) {
  BodiesOptions options = pair_of_bodies(0);
  EXPECT_NEAR(make_bodies<3>(options)->longest_step(0, 0.5), 0.5 / std::sqrt(2), 1e-14);
  options.core = "gauss";
  options.core_size = 1e-9;
  EXPECT_NEAR(make_bodies<3>(options)->longest_step(0, 0.5), 0.5 / std::sqrt(2), 1e-14);
  options.gravitational_constant = 0;
  EXPECT_TRUE(std::isinf(make_bodies<3>(options)->longest_step(0, 0.5)));
}

/// A body of mass 0 falls on the same path as one of the same place and velocity with a mass next
/// to nothing, and does not pull.
TEST(Bodies, WithoutMassFeelTheOthersAndDoNotPull) {
  const auto bodies = make_bodies<3>(
      {.masses = {{2, {0, 0, 0}, {}}, {0, {1, 0, 0}, {0, 1, 0}}, {0, {0, 2, 0}, {}}}});
  EXPECT_EQ(vector_of(*bodies, "acceleration", 0), (Vec<3>::Zero()));
  EXPECT_LT((vector_of(*bodies, "acceleration", 1) - Vec<3>(-2, 0, 0)).norm(), 1e-15);
  EXPECT_LT((vector_of(*bodies, "acceleration", 2) - Vec<3>(0, -0.5, 0)).norm(), 1e-15);
  take_steps(*bodies, VelocityVerlet(), 10, 0.01);
  EXPECT_EQ(vector_of(*bodies, "position", 0), (Vec<3>::Zero()));
  EXPECT_EQ(told(*bodies, "energy"), 0);  // of all that has mass
}

TEST(Bodies, CountHowOftenAccelerationsAreFormed) {
  const auto evaluations_in = [](auto method, int steps) {
    const auto bodies = make_bodies<3>(pair_of_bodies(1));
    const std::int64_t before = bodies->pair_work().evaluations;
    take_steps(*bodies, method, steps, 1e-3);
    const PairWork work = bodies->pair_work();
    EXPECT_EQ(work.pairs, 2 * work.evaluations);
    EXPECT_EQ(work.mean_neighbours, 1);
    return work.evaluations - before;
  };
  EXPECT_EQ(evaluations_in(VelocityVerlet(), 7), 1 + 7);
  EXPECT_EQ(evaluations_in(RungeKutta4(), 7), 7 * 4);
}

TEST(LagrangianRadii, HoldTheirPartsOfTheMass) {
  const double distance[] = {3, 1, 2, 4}, mass[] = {1, 2, 1, 6};
  EXPECT_EQ(lagrangian_radii(distance, mass, {0.1, 0.2, 0.21, 0.4, 0.5, 1}),
            (std::vector<double>{1, 1, 2, 3, 4, 4}));
}

}  // namespace
}  // namespace mote::test
