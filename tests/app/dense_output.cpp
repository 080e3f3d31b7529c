// Snapshots from a path between the ends of steps, which know nothing of them.

#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <sstream>

#include "flow_runs.hpp"

namespace mote::test {
namespace {

struct Way {
  std::string integrator, dense_output;
  std::string step;   ///< a line of the section `time`
  std::string error;  ///< of places at the end, relative, at most

  friend std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.integrator << ", " << way.dense_output;
  }
};

/// Two bodies of eccentricity 0.44 that go round some three times; no step ends near a snapshot.
std::string pair_of_bodies(const Way& way) {
  return "name: pair\ndimension: 3\nmodel:\n  type: bodies\n  masses:\n"
         "    - {mass: 1, position: [-0.25, 0, 0], velocity: [0, -0.75, 0]}\n"
         "    - {mass: 1, position: [0.25, 0, 0], velocity: [0, 0.75, 0]}\n"
         "time: {integrator: " +
         way.integrator + ", dense_output: " + way.dense_output + ", " + way.step +
         ", end: 2.9}\noutput: {every: 0.725, picture: false}\n"
         "check: {against: kepler, position: " +
         way.error + "}\n";
}

/// Two vortices that go round each other with the period 4.93; no step ends near a snapshot.
const std::string pair_of_vortices =
    "name: pair\ndimension: 2\ndomain: {lower: [-1, -1], upper: [1, 1]}\n"
    "particles: {spacing: 0.1}\nmodel:\n  type: vortex\n  core: point\n  vortices:\n"
    "    - {position: [-0.25, 0], circulation: 1}\n    - {position: [0.25, 0], circulation: 1}\n"
    "operator: vortex_blob.gauss\n"
    "time: {integrator: dormand_prince_853, tolerance: 1e-10, end: 6.1, dense_output: own}\n"
    "output: {every: 1.525, picture: false}\ncheck: {against: vortex_pair, position: 1e-7}\n";

nlohmann::json summary_of(const fs::path& out) {
  return nlohmann::json::parse(read(out / "summary.json"));
}

struct DenseOutput : FlowRuns, testing::WithParamInterface<Way> {};

TEST_P(DenseOutput, HasTheSameBitsAfterAResume) {
  expect_same_bits_after_a_resume(pair_of_bodies(GetParam()), {"1"});
}

/// With several frames within a step, a row of the history for every step, and steps that end at
/// frames by chance.
TEST_P(DenseOutput, HasTheSameRowsAfterAResume) {
  std::string scenario = pair_of_bodies(GetParam());
  const auto replace = [&](const std::string& old, const std::string& with) {
    scenario.replace(scenario.find(old), old.size(), with);
  };
  replace("end: 2.9", "end: 0.08");
  replace("every: 0.725", "every: 0.02, history: 1");
  expect_same_bits_after_a_resume(scenario, {"1"});
  std::istringstream rows(history_of(folder_ / "whole"));
  std::set<std::string> times;
  for (std::string row; std::getline(rows, row);)
    EXPECT_TRUE(times.insert(row.substr(0, row.find(','))).second) << "twice: " << row;
}

TEST_P(DenseOutput, LeavesStepsAsTheyAre) {
  const std::string scenario = pair_of_bodies(GetParam());
  const fs::path few = run(scenario, "few", {"--set", "output.every=2.9"});
  const fs::path many = run(scenario, "many", {"--set", "output.every=0.05"});
  EXPECT_EQ(summary_of(few)["steps"], summary_of(many)["steps"]);
  EXPECT_EQ(summary_of(few)["errors"], summary_of(many)["errors"]);
}

/// Negative control: without a path steps end at snapshots, and are other ones.
TEST_P(DenseOutput, IsNeededForThat) {
  if (GetParam().dense_output == "own" && GetParam().step.starts_with("step")) GTEST_SKIP();
  const std::string scenario = pair_of_bodies(GetParam());
  const std::vector<std::string> no_path{"--set", "time.dense_output=none", "--set",
                                         "check.position=1", "--set"};
  auto few_words = no_path, many_words = no_path;
  few_words.push_back("output.every=2.9");
  many_words.push_back("output.every=0.05");
  EXPECT_NE(summary_of(run(scenario, "few", few_words))["errors"],
            summary_of(run(scenario, "many", many_words))["errors"]);
}

using DenseOutputOfVortices = FlowRuns;

TEST_F(DenseOutputOfVortices, HasTheSameBitsAfterAResume) {
  expect_same_bits_after_a_resume(pair_of_vortices, {"1"});
}

TEST_F(DenseOutputOfVortices, LeavesStepsAsTheyAre) {
  const auto few = summary_of(run(pair_of_vortices, "few", {"--set", "output.every=6.1"}));
  const auto many = summary_of(run(pair_of_vortices, "many", {"--set", "output.every=0.0305"}));
  EXPECT_EQ(few["steps"], many["steps"]);
  EXPECT_EQ(few["errors"], many["errors"]);
  EXPECT_GT(few["evaluations"], 0);
}

/// Negative control: without a path steps end at snapshots.
TEST_F(DenseOutputOfVortices, IsNeededForThat) {
  const auto many =
      summary_of(run(pair_of_vortices, "many",
                     {"--set", "output.every=0.0305", "--set", "time.dense_output=none"}));
  EXPECT_GE(many["steps"], 200);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, DenseOutput,
    testing::Values(Way{"gauss_radau_15", "own", "tolerance: 1e-8", "1e-11"},
                    Way{"dormand_prince_853", "own", "tolerance: 1e-12", "1e-8"},
                    Way{"bulirsch_stoer", "own", "tolerance: 1e-13", "1e-9"},
                    Way{"runge_kutta_nystrom_1210", "three_step_hermite", "tolerance: 1e-12",
                        "1e-4"},
                    Way{"runge_kutta_nystrom_86", "two_step_hermite", "tolerance: 1e-12", "1e-6"},
                    Way{"leapfrog_kdk", "cubic_hermite", "step: 0.0004", "1e-4"},
                    Way{"velocity_verlet", "quintic_hermite", "step: 0.0005", "2e-4"},
                    Way{"runge_kutta_8", "quintic_hermite", "step: 0.011", "1e-6"},
                    Way{"contevol_1_corrected", "own", "step: 0.011", "1e-4"},
                    Way{"stoermer_13", "three_step_hermite", "step: 0.0055", "1e-7"}),
    [](const auto& info) { return info.param.integrator; });

}  // namespace
}  // namespace mote::test
