#include "mote/exact/steady_flows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace mote {
namespace {

/// The largest difference between the velocities of particles and both the change of their places
/// over a short time and the flow where they are.
double residual(const FlowSolution& flow, int dimension, double time) {
  constexpr double h = 1e-4;
  const auto columns = static_cast<std::size_t>(dimension);
  const Table before = flow.of_particles(time - h), after = flow.of_particles(time + h);
  const Table now = flow.of_particles(time);
  double worst = 0;
  for (std::size_t i = 0; i < now[0].values.size(); ++i) {
    std::vector<double> place;
    for (std::size_t d = 0; d < columns; ++d) place.push_back(now[d].values[i]);
    const Table there = flow.at_places(place, dimension, time);
    for (std::size_t d = 0; d < columns; ++d) {
      const double velocity = now[columns + d].values[i];
      const double change = (after[d].values[i] - before[d].values[i]) / (2 * h);
      worst =
          std::max({worst, std::abs(change - velocity), std::abs(there[d].values[0] - velocity)});
    }
  }
  return worst;
}

LinearVelocity swirl() {
  LinearVelocity velocity{.dimension = 3};
  velocity.gradient << -0.1, -2, 0.3, 2, -0.2, 0, 0, 0.5, 0.3;
  velocity.centre << 0.5, -0.25, 0;
  velocity.at_centre << 1, 0, -0.5;
  return velocity;
}

TEST(LinearFlow, IsAFlow) {
  const LinearFlow flow(swirl(), {1, 2, 3, -1, 0, 0.5});
  EXPECT_LT(residual(flow, 3, 0.8), 1e-7);
  EXPECT_EQ(flow.of_particles(0)[2].values, (std::vector<double>{3, 0.5}));
}

TEST(LinearFlow, OfARotationTurns) {
  LinearVelocity velocity;
  velocity.gradient(0, 1) = -1;
  velocity.gradient(1, 0) = 1;
  const Table at = LinearFlow(velocity, {1, 0}).of_particles(2);
  EXPECT_NEAR(at[0].values[0], std::cos(2.0), 1e-16);
  EXPECT_NEAR(at[3].values[0], std::cos(2.0), 1e-16);
}

TEST(FlowReference, DrawsABoundedNumberOfParticles) {
  std::vector<double> places;
  for (int k = 0; k < 999; ++k) places.insert(places.end(), {k + 0.0, 0, 0});
  const FlowReference many(std::make_unique<LinearFlow>(LinearVelocity{.dimension = 3}, places), 3);
  const Table curve = many.curve(1);
  EXPECT_EQ(curve.front().name, "position_x");
  EXPECT_EQ(curve.front().values.size(), 200);
  EXPECT_EQ(curve.front().values[199], 199 * 999 / 200);
  const FlowReference two(std::make_unique<LinearFlow>(swirl(), std::vector<double>(6)), 3);
  EXPECT_EQ(two.curve(1).front().values.size(), 2);
}

TEST(CircularFlow, IsAFlow) {
  const CircularFlow flow({1, -1}, {{0.5, 0.3, 2}, {2, 4, 0.5}, {1, 0, -1}});
  EXPECT_LT(residual(flow, 2, 0.8), 1e-7);
  const double place[] = {2.5, -1};  // between the radii 1 and 2
  EXPECT_NEAR(flow.at_places(place, 2, 0)[1].values[0], -0.25 * 1.5, 1e-15);
}

}  // namespace
}  // namespace mote
