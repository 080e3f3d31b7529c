// What a weakly compressible flow keeps: momentum, angular momentum, and the energy but for what
// viscosity takes.

#include <gtest/gtest.h>

#include <numbers>

#include "support/flow_case.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

constexpr double step = 0.002;

/// Every particle with a velocity of its own, whatever its place.
FlowCase& in_turmoil(FlowCase& flow, double speed = 0.3) {
  auto draws = std::make_shared<Draws>(3);
  flow.velocity = [=](const Place&) {
    return Triple{draws->uniform(-speed, speed), draws->uniform(-speed, speed),
                  draws->uniform(-speed, speed)};
  };
  return flow;
}

template <int D>
FlowCase periodic_box(Viscosity viscosity, DensityDiffusion diffusion) {
  FlowCase flow = flow_in_a_box(D, 0.1, {0.8, 0.8, 0.8}, {true, true, D == 3});
  flow.options.viscosity = viscosity;
  if (viscosity == Viscosity::morris) flow.options.kinematic_viscosity = 0.05;
  flow.options.alpha = 0.2;
  flow.options.diffusion = diffusion;
  flow.options.free_surface = false;
  return in_turmoil(in_disorder(flow));
}

/// How far the momentum drifts in 50 steps, relative to the sum of m |u|.
template <int D>
double drift_of_momentum(FlowCase flow) {
  const auto made = make_flow<D>(flow);
  const auto start = made->conserved();
  run(*made, 50 * step, 50);
  return drift_between(start, made->conserved());
}

TEST(Momentum, IsKeptByEveryPairTermInAPeriodicBox) {
  for (const Viscosity viscosity : {Viscosity::none, Viscosity::morris, Viscosity::artificial})
    for (const DensityDiffusion diffusion :
         {DensityDiffusion::none, DensityDiffusion::molteni, DensityDiffusion::fourtakas,
          DensityDiffusion::antuono}) {
      EXPECT_LT(drift_of_momentum<2>(periodic_box<2>(viscosity, diffusion)), 1e-13)
          << static_cast<int>(viscosity) << ", " << static_cast<int>(diffusion);
    }
  EXPECT_LT(drift_of_momentum<3>(periodic_box<3>(Viscosity::artificial, DensityDiffusion::molteni)),
            1e-13);
}

/// Negative control: derivatives that are not symmetric in the pair keep no momentum.
TEST(Momentum, IsNotKeptByTheCorrectedOperator) {
  FlowCase flow = periodic_box<2>(Viscosity::none, DensityDiffusion::none);
  flow.options.pressure = Derivatives::by_operator;
  EXPECT_GT(drift_of_momentum<2>(flow), 1e-6);
}

FlowCase free_blob(Viscosity viscosity) {
  FlowCase flow = flow_in_a_box(2, 0.1, {1, 1});
  flow.options.viscosity = viscosity;
  if (viscosity == Viscosity::morris) flow.options.kinematic_viscosity = 0.05;
  flow.options.alpha = 0.2;
  flow.options.diffusion = DensityDiffusion::none;
  flow.pressure = [](const Place& at) { return 2 * at[0] * (1 - at[1]); };
  return in_turmoil(in_disorder(flow));
}

/// Sum of m x x u, and of the magnitudes of its terms.
std::pair<double, double> angular_momentum(const WeaklyCompressible<2>& flow) {
  double sum = 0, magnitude = 0;
  for (const Index i : fluid_of(flow)) {
    const Vec<2> x = vector_of(flow, "position", i), u = vector_of(flow, "velocity", i);
    sum += x[0] * u[1] - x[1] * u[0];
    magnitude += x.norm() * u.norm();
  }
  return {sum, magnitude};
}

double drift_of_angular_momentum(Viscosity viscosity) {
  const auto flow = make_flow<2>(free_blob(viscosity));
  const auto [start, scale] = angular_momentum(*flow);
  run(*flow, 50 * step, 50);
  return std::abs(angular_momentum(*flow).first - start) / scale;
}

TEST(AngularMomentum, IsKeptByForcesAlongTheLineOfThePair) {
  EXPECT_LT(drift_of_angular_momentum(Viscosity::none), 1e-13);
  EXPECT_LT(drift_of_angular_momentum(Viscosity::artificial), 1e-13);
}

/// Negative control: Morris' viscosity acts along the difference of the velocities.
TEST(AngularMomentum, IsNotKeptByMorrisViscosity) {
  EXPECT_GT(drift_of_angular_momentum(Viscosity::morris), 1e-6);
}

/// Vortices in a periodic box of disorder, with energies of all kinds.
FlowCase vortices(Viscosity viscosity) {
  FlowCase flow = flow_in_a_box(2, 0.1, {1, 1}, {true, true, false});
  flow.options.viscosity = viscosity;
  if (viscosity == Viscosity::morris) flow.options.kinematic_viscosity = 0.02;
  flow.options.alpha = 0.2;
  flow.options.diffusion = DensityDiffusion::none;
  flow.options.free_surface = false;
  const double k = 2 * std::numbers::pi;
  flow.velocity = [=](const Place& at) {
    return Triple{std::sin(k * at[0]) * std::cos(k * at[1]),
                  -std::cos(k * at[0]) * std::sin(k * at[1])};
  };
  flow.pressure = [=](const Place& at) { return 2 * std::sin(k * at[0]); };
  return in_disorder(flow, 0.1);
}

/// Energy, and what viscosity took by the trapezoidal rule, against the energy at the start: the
/// largest gap on the way, relative to the kinetic energy at the start.
double gap_in_budget(const FlowCase& given, int steps, bool with_dissipation = true) {
  const auto flow = make_flow<2>(given);
  VelocityVerlet integrator;
  const double end = 0.2, length = end / steps;
  update_rates(*flow);
  const double start = told(*flow, "energy"), kinetic = told(*flow, "kinetic_energy");
  double dissipated = 0, before = told(*flow, "viscous_power"), most = 0;
  for (int k = 0; k < steps; ++k) {
    step_once(*flow, integrator, k * length, length);
    const double after = told(*flow, "viscous_power");
    dissipated += 0.5 * (before + after) * length;
    before = after;
    const double taken = with_dissipation ? dissipated : 0;
    most = std::max(most, std::abs(told(*flow, "energy") + taken - start) / kinetic);
  }
  return most;
}

TEST(EnergyBudget, ClosesToSecondOrderInTheStep) {
  for (const Viscosity viscosity : {Viscosity::none, Viscosity::morris, Viscosity::artificial}) {
    const FlowCase flow = vortices(viscosity);
    const double coarse = gap_in_budget(flow, 600), fine = gap_in_budget(flow, 1200);
    const double order = std::log2(coarse / fine);
    EXPECT_GT(order, 1.8) << static_cast<int>(viscosity) << ": " << coarse << ", " << fine;
    EXPECT_LT(order, 2.6) << static_cast<int>(viscosity) << ": " << coarse << ", " << fine;
    EXPECT_LT(fine, 1e-5);
  }
}

/// Negative control: without what viscosity took, or with a diffusion that is in no budget, the gap
/// does not close with the step.
TEST(EnergyBudget, StaysOpenWhereSomethingIsLeftOut) {
  const FlowCase viscous = vortices(Viscosity::morris);
  const double coarse = gap_in_budget(viscous, 100, false);
  EXPECT_NEAR(coarse / gap_in_budget(viscous, 200, false), 1, 0.1);
  FlowCase diffusing = vortices(Viscosity::none);
  diffusing.options.diffusion = DensityDiffusion::molteni;
  EXPECT_NEAR(gap_in_budget(diffusing, 100) / gap_in_budget(diffusing, 200), 1, 0.1);
}

}  // namespace
}  // namespace mote::test
