// What an incompressible flow keeps: its momentum, where all pairs act on both ends alike.

#include <gtest/gtest.h>

#include "support/incompressible_case.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

/// A periodic box of disorder in which every particle has a velocity of its own, whatever its
/// place.
template <int D>
IncompressibleCase turmoil(PressureGradient gradient) {
  auto flow = incompressible_box<D>(0.1, {0.8, 0.8, 0.8}, {true, true, D == 3});
  with_operator(without_surface(flow), symmetric_mps<D>());
  flow.options.gradient = gradient;
  flow.options.kinematic_viscosity = 0.01;
  flow.options.shifting = 0.5;
  flow.options.collision_distance = 0.8;
  auto draws = std::make_shared<Draws>(3);
  flow.velocity = [=](const Place&) {
    return Triple{draws->uniform(-0.3, 0.3), draws->uniform(-0.3, 0.3), draws->uniform(-0.3, 0.3)};
  };
  return in_disorder(flow);
}

/// How far the momentum drifts in 20 steps, relative to the sum of m |u| at the start.
template <int D>
double drift_of_momentum(const IncompressibleCase& given) {
  const auto flow = make_incompressible<D>(given);
  const auto start = flow->conserved();
  take_steps(*flow, 20, 0.002);
  return drift_between(start, flow->conserved());
}

TEST(IncompressibleMomentum, IsKeptByTheSymmetricGradientOfMps) {
  EXPECT_LT(drift_of_momentum<2>(turmoil<2>(PressureGradient::symmetric)), 1e-13);
  EXPECT_LT(drift_of_momentum<3>(turmoil<3>(PressureGradient::symmetric)), 1e-13);
}

/// Negative control: differences of the pressure act on both ends in the same direction.
TEST(IncompressibleMomentum, IsNotKeptByOtherGradients) {
  EXPECT_GT(drift_of_momentum<2>(turmoil<2>(PressureGradient::plain)), 1e-6);
  EXPECT_GT(drift_of_momentum<2>(turmoil<2>(PressureGradient::repulsive)), 1e-6);
}

/// Negative control: constants of its own make a particle's weights others than its neighbours'.
TEST(IncompressibleMomentum, IsNotKeptByLocalConstants) {
  auto flow = turmoil<2>(PressureGradient::symmetric);
  Mps<2> local;
  local.smoothing_length = 3.1;
  EXPECT_GT(drift_of_momentum<2>(with_operator(flow, local)), 1e-6);
}

}  // namespace
}  // namespace mote::test
