#include "mote/models/collisions.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "mote/integrators/all.hpp"
#include "mote/particles/failure.hpp"
#include "support/bodies_case.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A ball at rest and one that flies past its centre at this distance, from -1 to 1 in a time of 2;
/// they touch at the distance 0.5.
BodiesOptions passing(double distance) {
  BodiesOptions options{.gravitational_constant = 0};
  options.masses = {{1, {0, 0, 0}, {}, "Earth", 0.3},
                    {0, {-1, distance, 0}, {1, 0, 0}, "Comet", 0.2}};
  return options;
}

std::unique_ptr<Bodies<3>> passed(const BodiesOptions& options, int steps) {
  auto bodies = make_bodies<3>(options);
  take_steps(*bodies, VelocityVerlet(), steps, 2.0 / steps);
  return bodies;
}

double collisions_in(const Bodies<3>& bodies) { return told(bodies, "collisions"); }

TEST(Collisions, AreSeenThatTheEndsOfStepsMiss) {
  const auto bodies = passed(passing(0.3), 1);
  EXPECT_GT(told(*bodies, "separation"), 1);
  EXPECT_EQ(collisions_in(*bodies), 1);
  // sqrt(0.5^2 - 0.3^2) before the middle
  EXPECT_THAT(bodies->warnings(),
              ElementsAre(HasSubstr("1 collision: Earth and Comet at t = 0.6 with the relative "
                                    "speed 1. The bodies went through each other")));
}

TEST(Collisions, AreSeenWhenTheyGraze) {
  EXPECT_EQ(collisions_in(*passed(passing(0.5 * (1 - 1e-12)), 1)), 1);
  EXPECT_EQ(collisions_in(*passed(passing(0.5 * (1 - 1e-12)), 7)), 1);
}

/// Negative control.
TEST(Collisions, AreNotSeenWhereBodiesPassEachOther) {
  for (const int steps : {1, 2, 7, 100}) {
    const auto bodies = passed(passing(0.5 * (1 + 1e-12)), steps);
    EXPECT_EQ(collisions_in(*bodies), 0) << steps;
    EXPECT_THAT(bodies->warnings(), IsEmpty());
  }
}

TEST(Collisions, AreCountedOnceForAnyLengthOfStep) {
  for (const int steps : {1, 2, 3, 10, 100}) {
    const auto bodies = passed(passing(0.3), steps);
    EXPECT_EQ(collisions_in(*bodies), 1) << steps;
    EXPECT_THAT(bodies->warnings().front(), HasSubstr("at t = 0.6 with"));
  }
}

TEST(Collisions, NeedTwoBallsAndNoPoints) {
  BodiesOptions options = passing(0);
  options.masses[0].radius.reset();
  const auto bodies = passed(options, 3);
  EXPECT_FALSE(bodies->cloud().has("collisions"));
  EXPECT_THAT(bodies->warnings(), IsEmpty());
  options.masses[0].radius = 0;  // a point that collides with balls
  EXPECT_EQ(collisions_in(*passed(options, 3)), 1);
}

TEST(Collisions, LeaveTheMotionAsItIs) {
  BodiesOptions options = passing(0.3);
  options.gravitational_constant = 1;
  const auto watched = passed(options, 50);
  EXPECT_EQ(collisions_in(*watched), 1);
  for (PointMass& body : options.masses) body.radius.reset();
  const auto unwatched = passed(options, 50);
  EXPECT_EQ(vector_of(*watched, "position", 1), vector_of(*unwatched, "position", 1));
}

/// On an ellipse of eccentricity 1/2 about a mass of 1, a = 1, from the furthest point on: at the
/// distance r = 1 - e cos E, after the time pi + E - e sin E since then, E from -pi on.
TEST(Collisions, AreAtTheTimeOfKeplersEquation) {
  const double e = 0.5, distance = 0.6, anomaly = -std::acos((1 - distance) / e);
  const double expected = std::numbers::pi + anomaly - e * std::sin(anomaly);
  BodiesOptions options;
  options.masses = {{1, {0, 0, 0}, {}, "Sun", 0.5},
                    {0, {1 + e, 0, 0}, {0, std::sqrt((1 - e) / (1 + e)), 0}, "Comet", 0.1}};
  const auto error = [&](int steps) {
    const auto bodies = make_bodies<3>(options);
    take_steps(*bodies, RungeKutta4(), steps, std::numbers::pi / steps);
    const std::string words = bodies->warnings().front();
    return std::abs(std::stod(words.substr(words.find("t = ") + 4)) - expected);
  };
  EXPECT_LT(error(40), 1e-5);
  EXPECT_LT(error(320), 1e-8);  // nine digits are told
}

TEST(Collisions, OfOrderFourBetweenTheEndsOfAStep) {
  // Two bodies on a circle of radius 1 about each other's middle: always 2 apart, in Hermite's
  // cubic a little more or less.
  const auto gap = [](double step) {
    const Vec<2> end{std::cos(step), std::sin(step)}, turn{-std::sin(step), std::cos(step)};
    const Approach<2> approach({Vec<2>(2, 0), 2 * end}, {step * Vec<2>(0, 2), step * 2 * turn});
    double low = 1.9, high = 2 - 1e-15;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (approach.first_within(middle) ? high : low) = middle;
    }
    return 2 - high;
  };
  EXPECT_NEAR(std::log2(gap(0.8) / gap(0.4)), 4, 0.1);
  EXPECT_LT(gap(0.4), 2e-4);
}

TEST(Collisions, MayNotBeThereAtTheStart) {
  EXPECT_THROW(
      make_bodies<3>({.masses = {{1, {0, 0, 0}, {}, "A", 0.5}, {1, {1, 0, 0}, {}, "B", 0.5}}}),
      InputError);
}

}  // namespace
}  // namespace mote::test
