// Whole runs of bodies: the same bits by any way.

#include "flow_runs.hpp"

namespace mote::test {
namespace {

/// A Plummer sphere that a body passes, by the multipole method and in numbers for several threads.
constexpr const char* sphere = R"yaml(name: sphere
dimension: 3
domain: {lower: [-2, -2, -2], upper: [2, 2, 2]}
particles: {spacing: 0.1}
model:
  type: bodies
  sum: {method: multipole, tolerance: 1e-6}
  softening: {name: algebraic.2, size: 0.05}
  masses: [{mass: 0.1, position: [3, 0, 0], velocity: [-1, 0.1, 0]}]
  clusters: [{type: plummer, count: 5000, scale_radius: 1}]
operator: sph.gauss
time: {integrator: velocity_verlet, step: 0.02, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// A disc in the plane, pair by pair, with steps that follow the accelerations.
constexpr const char* disc = R"yaml(name: disc
dimension: 2
domain: {lower: [-1, -1], upper: [1, 1]}
particles: {spacing: 0.1}
model:
  type: bodies
  sum: {method: direct}
  softening: {name: gauss, size: 0.05}
  clusters: [{type: uniform_ball, count: 4500, radius: 1}]
operator: sph.gauss
time: {integrator: runge_kutta_4, courant: 0.2, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

struct BodiesRun : FlowRuns, testing::WithParamInterface<const char*> {};

TEST_P(BodiesRun, HasTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits_for_any_number_of_threads(GetParam());
}

TEST_P(BodiesRun, HasTheSameBitsAfterAResume) {
  expect_same_bits_after_a_resume(GetParam(), {"1", "4"});
}

/// Negative control of the comparisons above.
TEST_P(BodiesRun, HasOtherBitsWithAnotherSoftening) {
  const fs::path one = run(GetParam(), "one");
  const fs::path other = run(GetParam(), "other", {"--set", "model.softening.size=0.06"});
  EXPECT_NE(read(one / frames.back()), read(other / frames.back()));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, BodiesRun, testing::Values(sphere, disc));

}  // namespace
}  // namespace mote::test
