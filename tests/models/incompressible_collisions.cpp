// Particles of an incompressible fluid that come too close part again.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/incompressible_case.hpp"

namespace mote::test {
namespace {

constexpr double spacing = 0.1, restitution = 0.4;

/// A block of fluid on a wall, and room beside it.
IncompressibleCase block() {
  auto flow = incompressible_box<2>(spacing, {0.8, 0.8});
  flow.plan.upper = {4, 2};
  flow.options.collision_distance = 0.8;
  flow.options.restitution = restitution;
  return with_wall(flow, 1, false);
}

/// Adds one particle, by the lower corner of its cell.
void add_particle(IncompressibleCase& flow, const std::string& name, double x, double y) {
  Extent cell;
  std::ranges::copy(std::array{x, y}, cell.lower.begin());
  std::ranges::copy(std::array{x + spacing, y + spacing}, cell.upper.begin());
  flow.plan.regions.push_back(
      {.body = {.name = name}, .whole = std::make_shared<Box>(cell), .key = name});
}

/// Two particles far from the block, a spacing apart, that fly at these velocities along x.
IncompressibleCase two_in_flight(double left, double right) {
  auto flow = block();
  add_particle(flow, "left", 3, 1.5);
  add_particle(flow, "right", 3 + spacing, 1.5);
  flow.velocity = [=](const Place& at) {
    if (at[0] < 2) return Triple{};
    return Triple{at[0] < 3 + spacing ? left : right, 0.3};
  };
  return flow;
}

/// Velocities along x of the particles on the left and on the right in the end.
std::pair<double, double> after_flight(const IncompressibleCase& given) {
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, 10, 0.05 * spacing);
  std::vector<std::pair<double, double>> found;
  for (const Index i : fluid_of(*flow)) {
    const Vec<2> x = vector_of(*flow, "position", i);
    if (x[0] > 2) found.emplace_back(x[0], vector_of(*flow, "velocity", i)[0]);
  }
  std::ranges::sort(found);
  EXPECT_EQ(found.size(), 2);
  return {found.front().second, found.back().second};
}

TEST(Collision, LeavesPartOfTheApproachAndTheMomentum) {
  const auto [left, right] = after_flight(two_in_flight(1, -0.5));
  EXPECT_NEAR(right - left, restitution * 1.5, 1e-15);
  EXPECT_NEAR(left + right, 0.5, 1e-15);
}

/// Negative controls: those that part do not meet, nor do any where it is not asked for.
TEST(Collision, IsNotOfParticlesThatPart) {
  const auto [left, right] = after_flight(two_in_flight(-0.5, 1));
  EXPECT_EQ(left, -0.5);
  EXPECT_EQ(right, 1);
}

TEST(Collision, IsNotWithoutADistance) {
  auto flow = two_in_flight(1, -0.5);
  flow.options.collision_distance = 0;
  const auto [left, right] = after_flight(flow);
  EXPECT_EQ(left, 1);
  EXPECT_EQ(right, -0.5);
}

/// Velocity of a particle that falls on the wall, or from a little above it upwards, where the wall
/// comes towards it at some speed.
Vec<2> after_fall(double velocity, double distance, double speed_of_wall = 0) {
  auto given = block();
  given.options.collision_distance = distance;
  given.plan.walls[0].body.velocity = [=](double) { return Triple{0, speed_of_wall}; };
  add_particle(given, "drop", 3, 0);
  given.velocity = [=](const Place& at) { return at[0] < 2 ? Triple{} : Triple{0.2, velocity}; };
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, 4, 0.05 * spacing);
  for (const Index i : fluid_of(*flow))
    if (vector_of(*flow, "position", i)[0] > 2) return vector_of(*flow, "velocity", i);
  throw std::logic_error("the drop is gone");
}

TEST(Collision, WithAWallTurnsTheVelocityAcrossIt) {
  const Vec<2> found = after_fall(-1, 0.8);
  EXPECT_NEAR(found[0], 0.2, 1e-15);
  EXPECT_NEAR(found[1], restitution, 1e-15);
}

TEST(Collision, WithAWallThatComesIsByTheSpeedOfTheApproach) {
  EXPECT_NEAR(after_fall(-1, 0.8, 0.5)[1], 0.5 + restitution * 1.5, 1e-15);
}

/// A drop that is not yet within half of the distance falls on.
TEST(Collision, WithAWallIsAtHalfTheDistance) { EXPECT_EQ(after_fall(-0.4, 0.8)[1], -0.4); }

/// Negative controls: a drop that rises, and one that nothing holds.
TEST(Collision, WithAWallIsNotOfADropThatRises) {
  EXPECT_EQ(after_fall(1, 0.8)[1], 1);
  EXPECT_EQ(after_fall(-1, 0)[1], -1);
}

}  // namespace
}  // namespace mote::test
