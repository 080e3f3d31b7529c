// Whole runs of an incompressible fluid: the same bits by any way, and what they write.

#include <nlohmann/json.hpp>

#include "flow_runs.hpp"

namespace mote::test {
namespace {

using nlohmann::json;

/// A column of water that begins to fall in a tank, with particles enough for several threads.
constexpr const char* falling = R"(name: falling
dimension: 2
domain:
  lower: [0, 0]
  upper: [1, 0.6]
  walls: [{side: x_lower, slip: free}, {side: x_upper, slip: free}, {side: y_lower, slip: free}]
particles: {spacing: 0.01}
regions:
  - {name: water, type: fluid, shapes: [{type: box, lower: [0, 0], upper: [0.9, 0.5]}]}
model:
  {type: incompressible, density: 1000, gravity: [0, -9.81], laplacian: mps,
   collisions: {distance: 0.5}}
neighbours: {skin: 0.01}
operator: {family: corrected_mps}
time: {courant: 0.1, end: 0.04}
output: {every: 0.01, picture: false}
)";

/// Vortices that nothing but each other turns, in a box without a surface.
constexpr const char* vortices = R"yaml(name: vortices
dimension: 2
domain: {lower: [0, 0], upper: [1, 1], periodic: [x], walls: [{side: y_lower}, {side: y_upper}]}
particles: {spacing: 0.0125, layout: jittered, jitter: 0.2}
model:
  {type: incompressible, kinematic_viscosity: 0.01, free_surface: false, mean_pressure: 3,
   shifting: 1}
initial: {velocity_x: "sin(2*pi*x)*cos(pi*y)", velocity_y: "-2*cos(2*pi*x)*sin(pi*y)"}
neighbours: {skin: 0.01}
operator: {family: corrected_sph, kernel: wendland_c2, smoothing_length: 1.5}
time: {courant: 0.2, end: 0.02}
output: {every: 0.005, picture: false}
)yaml";

struct IncompressibleRun : FlowRuns, testing::WithParamInterface<const char*> {};

TEST_P(IncompressibleRun, HasTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits_for_any_number_of_threads(GetParam());
}

TEST_P(IncompressibleRun, HasTheSameBitsAfterAResume) {
  expect_same_bits_after_a_resume(GetParam(), {"1", "4"});
}

/// Negative control of the comparisons above.
TEST_P(IncompressibleRun, HasOtherBitsWithAnotherTolerance) {
  const fs::path whole = run(GetParam(), "whole");
  const fs::path other = run(GetParam(), "other", {"--set", "model.solver.tolerance=1e-4"});
  EXPECT_NE(history_of(whole), history_of(other));
  EXPECT_FALSE(read(whole / frames[4]) == read(other / frames[4]));
}

/// Negative control of the bits after a resume: neighbours were found anew on the way.
TEST_P(IncompressibleRun, FindsNeighboursAnewBetweenFrames) {
  const std::string report = read(run(GetParam(), "out") / "report.md"), word = "found anew ";
  ASSERT_NE(report.find(word), std::string::npos);
  EXPECT_GT(std::stoi(report.substr(report.find(word) + word.size())), 1 + 5);
}

INSTANTIATE_TEST_SUITE_P(, IncompressibleRun, testing::Values(falling, vortices),
                         [](const auto& run) { return run.index == 0 ? "falling" : "vortices"; });

using IncompressibleHistory = FlowRuns;

TEST_F(IncompressibleHistory, HasReadingsAndTheSummaryConservation) {
  const fs::path out = run(falling, "out");
  const std::string history = read(out / "history.csv");
  const std::string header = ',' + history.substr(0, history.find('\n')) + ',';
  for (const char* name : {"iterations", "residual", "divergence", "solver_share", "volume_error"})
    EXPECT_NE(header.find(',' + std::string(name) + ','), std::string::npos) << name;
  const json summary = json::parse(read(out / "summary.json"));
  EXPECT_EQ(summary["conservation"]["mass"]["drift"], 0);
  EXPECT_TRUE(summary["conservation"].contains("momentum_y"));
}

}  // namespace
}  // namespace mote::test
