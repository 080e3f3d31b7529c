#include "mote/catalogue/exact_tracers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using Velocity = std::function<Vec<2>(const Vec<2>&)>;

/// Tracers on a lattice of 6 x 6 that start with a velocity, and what is made of them.
struct Start {
  SpaceStart start;
  Cloud cloud{2, 36};
  Parameters parameters{{"tracers", 1}, {"steady", 1}};

  explicit Start(const Velocity& velocity) {
    const auto values = cloud.add("velocity", FieldKind::vector, "");
    for (int i = 0; i < 36; ++i) {
      const Vec<2> place(0.3 * (i % 6) - 1, 0.2 * (i / 6));
      Vec<2>::Map(&cloud.position()[2 * static_cast<std::size_t>(i)]) = place;
      Vec<2>::Map(&values[2 * static_cast<std::size_t>(i)]) = velocity(place);
    }
  }

  std::unique_ptr<FlowSolution> solution(const std::string& name) const {
    for (const ExactEntry& entry : tracer_entries())
      if (entry.name == name) return entry.make_flow({start, parameters, cloud});
    throw std::logic_error("no solution " + name);
  }
};

/// About (0.5, 0.3), the faster the nearer to it.
Vec<2> vortex(const Vec<2>& x) {
  const Vec<2> d = x - Vec<2>(0.5, 0.3);
  return Vec<2>(-d[1], d[0]) * std::exp(-d.squaredNorm());
}

TEST(TracersExact, LinearFlowsAreRecognised) {
  const Start shear([](const Vec<2>& x) { return Vec<2>(1 + 2 * x[1], -1); });
  const Table end = shear.solution("linear_flow")->of_particles(3);
  for (std::size_t i = 0; i < 36; ++i) {
    const double x = shear.cloud.position()[2 * i], y = shear.cloud.position()[2 * i + 1];
    EXPECT_NEAR(end[0].values[i], x + 3 * (1 + 2 * y) - 9, 1e-13);
    EXPECT_NEAR(end[1].values[i], y - 3, 1e-13);
  }
}

/// Velocities of places far from the origin keep the digits that the places have.
TEST(TracersExact, LinearFlowsFarFromTheOriginKeepTheirDigits) {
  constexpr double far = 0x1p20;
  Start shear([](const Vec<2>&) { return Vec<2>(0, 0); });
  const auto place = shear.cloud.position();
  for (std::size_t i = 0; i < 36; ++i) {
    place[2 * i + 1] += far;
    shear.cloud.values("velocity")[2 * i] = place[2 * i + 1] - far;
  }
  const Table end = shear.solution("linear_flow")->of_particles(3);
  for (std::size_t i = 0; i < 36; ++i) {
    const double y = place[2 * i + 1] - far;
    EXPECT_NEAR(end[0].values[i], place[2 * i] + 3 * y, 1e-14);
    EXPECT_NEAR(end[2].values[i], y, 1e-14);
  }
}

TEST(TracersExact, KnowWhatPeriodicSidesMean) {
  const auto periodic = [](const Velocity& velocity, int axis, double upper) {
    Start start(velocity);
    start.start.lower = {-1.5, -1.5};
    start.start.upper = {upper, upper};
    start.start.periodic[static_cast<std::size_t>(axis)] = true;
    return start;
  };
  const Velocity shear = [](const Vec<2>& x) { return Vec<2>(2 * x[1], 0); };
  EXPECT_NO_THROW(periodic(shear, 0, 3).solution("linear_flow"));
  EXPECT_THROW(periodic(shear, 1, 3).solution("linear_flow"), InputError);
  EXPECT_NO_THROW(periodic(vortex, 0, 3).solution("circular_flow"));
  EXPECT_THROW(periodic(vortex, 0, 1.5).solution("circular_flow"), InputError);
}

TEST(TracersExact, VorticesAreRecognised) {
  const Start start(vortex);
  const Table end = start.solution("circular_flow")->of_particles(2);
  for (std::size_t i = 0; i < 36; ++i) {
    const Vec<2> d = Vec<2>::Map(&start.cloud.position()[2 * i]) - Vec<2>(0.5, 0.3);
    const double turn = 2 * std::exp(-d.squaredNorm());
    EXPECT_NEAR(end[0].values[i], 0.5 + std::cos(turn) * d[0] - std::sin(turn) * d[1], 1e-13);
    EXPECT_NEAR(end[1].values[i], 0.3 + std::sin(turn) * d[0] + std::cos(turn) * d[1], 1e-13);
  }
}

TEST(TracersExact, OtherStartsAreRefused) {
  const Start curved([](const Vec<2>& x) { return Vec<2>(x[1] * x[1], 0.5); });
  EXPECT_THROW(curved.solution("linear_flow"), InputError);
  EXPECT_THROW(curved.solution("circular_flow"), InputError);
  const Start strained([](const Vec<2>& x) { return Vec<2>(x[0], -x[1]); });
  EXPECT_THROW(strained.solution("circular_flow"), InputError);
  EXPECT_NO_THROW(strained.solution("linear_flow"));
  EXPECT_THROW(Start(vortex).solution("linear_flow"), InputError);
  Start other(vortex);
  other.parameters.clear();
  EXPECT_THROW(other.solution("circular_flow"), InputError);
  Start unsteady(vortex);
  unsteady.parameters["steady"] = 0;
  EXPECT_THROW(unsteady.solution("circular_flow"), InputError);
}

}  // namespace
}  // namespace mote
