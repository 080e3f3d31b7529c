#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mote::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;

/// Runs a scenario and returns its summary.
json summary_of(const fs::path& out, const std::vector<std::string>& assignments = {},
                const std::string& scenario = "gravity/trapezoid.yaml") {
  mote(run_arguments(scenario, out, assignments));
  return json::parse(read(out / "summary.json"));
}

TEST(Run, LeavesTheFilesOfTheContract) {
  const TemporaryFolder folder;
  const auto outcome =
      mote({"run", MOTE_SCENARIOS "/gravity/trapezoid.yaml", "--out", (folder / "out").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("picture: " + (folder / "out/fields.png").string()));
  EXPECT_THAT(outcome.output, HasSubstr("report:  " + (folder / "out/report.md").string()));
  for (const char* name : {"run.yaml", "summary.json", "report.md", "history.csv", "exact.csv",
                           "snapshots.hdf.series", "snapshots/000000.hdf", "snapshots/000010.hdf"})
    EXPECT_TRUE(fs::exists(folder / "out" / name)) << name;
  EXPECT_EQ(read(folder / "out/fields.png").substr(1, 3), "PNG");
}

TEST(Run, SummaryHasTheKeysOfTheContract) {
  const TemporaryFolder folder;
  const json summary = summary_of(folder / "out");
  for (const char* key :
       {"name", "version", "dimension", "particles", "operator", "integrator", "steps", "time",
        "wall_seconds", "particle_updates_per_second", "pairs_per_second", "mean_neighbours",
        "errors", "conservation", "checks", "passed"})
    EXPECT_TRUE(summary.contains(key)) << key;
  EXPECT_EQ(summary["steps"], 30000);
  EXPECT_EQ(summary["time"], 7.5);
  EXPECT_EQ(summary["passed"], true);
  for (const char* norm : {"l1", "l2", "max"})
    EXPECT_TRUE(summary["errors"]["density"].contains(norm)) << norm;
  for (const char* key : {"start", "end", "drift"})
    EXPECT_TRUE(summary["conservation"]["mass"].contains(key)) << key;
}

TEST(Run, FailedCheckIsExitCodeOneAndSaidInTheReport) {
  const TemporaryFolder folder;
  const auto outcome =
      mote(run_arguments("gravity/trapezoid.yaml", folder / "out", {"check.density=1e-9"}));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(read(folder / "out/report.md"), HasSubstr("**A check failed.**"));
  EXPECT_EQ(json::parse(read(folder / "out/summary.json"))["passed"], false);
}

/// The limits of the file hold for every operator, unless it has others for standing points.
TEST(Run, ChecksStandingPointsToo) {
  const TemporaryFolder folder;
  const json summary = summary_of(folder / "out", {"operator=finite_difference",
                                                   "check={against: gravitating_sheets, "
                                                   "density: 0.01, drift: {mass: 1}}"});
  ASSERT_EQ(summary["checks"].size(), 2);
  EXPECT_EQ(summary["passed"], false);
}

TEST(Run, QuietPrintsNothing) {
  const TemporaryFolder folder;
  auto arguments = run_arguments("gravity/slab.yaml", folder / "out");
  arguments.emplace_back("--quiet");
  const auto outcome = mote(arguments);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, IsEmpty());
  EXPECT_THAT(outcome.errors, IsEmpty());
}

TEST(Run, OverwriteReplacesARunAndNothingElse) {
  const TemporaryFolder folder;
  auto arguments = run_arguments("gravity/slab.yaml", folder / "out", {"output.every=0.5"});
  EXPECT_EQ(mote(arguments).exit_code, 0);
  write(folder / "out/notes.txt", "mine");
  write(folder / "out/snapshots/mine.csv", "mine");
  arguments = run_arguments("gravity/slab.yaml", folder / "out");
  EXPECT_EQ(mote(arguments).exit_code, 2);
  EXPECT_TRUE(fs::exists(folder / "out/snapshots/000015.hdf"));
  arguments.emplace_back("--overwrite");
  EXPECT_EQ(mote(arguments).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "out/snapshots/000015.hdf"));
  EXPECT_EQ(read(folder / "out/snapshots/mine.csv"), "mine");
  EXPECT_EQ(read(folder / "out/notes.txt"), "mine");
}

TEST(Run, ResolvedScenarioRunsToTheSameState) {
  const TemporaryFolder folder;
  mote(run_arguments("gravity/rectangle.yaml", folder / "first",
                     {"operator.kernel=lucy", "model.density=continuity"}));
  const auto outcome = mote({"run", (folder / "first/run.yaml").string(), "--out",
                             (folder / "second").string(), "--quiet"});
  EXPECT_LE(outcome.exit_code, 1) << outcome.errors;
  EXPECT_EQ(read(folder / "first/snapshots/000010.hdf"),
            read(folder / "second/snapshots/000010.hdf"));
  EXPECT_EQ(read(folder / "first/run.yaml"), read(folder / "second/run.yaml"));
  EXPECT_THAT(read(folder / "first/run.yaml"), HasSubstr("kernel: lucy"));
}

TEST(Run, HistoryEndsWithTheSummary) {
  const TemporaryFolder folder;
  const json summary = summary_of(folder / "out");
  const std::string history = read(folder / "out/history.csv");
  EXPECT_THAT(history, testing::StartsWith("time,step,mass,momentum,energy\n0,0,"));
  const auto last = history.rfind('\n', history.size() - 2) + 1;
  EXPECT_THAT(history.substr(last), testing::StartsWith("7.5,30000,"));
  EXPECT_EQ(std::ranges::count(history, '\n'), 1 + 1 + 100);
}

TEST(Run, UnequalStepsAreShortenedToHitTheSnapshots) {
  const TemporaryFolder folder;
  const json summary = summary_of(
      folder / "out",
      {"time.step=0.004", "time.end=1.0", "output.every=0.3", "time.integrator=velocity_verlet"});
  EXPECT_EQ(summary["time"], 1.0);
  EXPECT_EQ(summary["steps"], 75 + 75 + 75 + 25);
  EXPECT_LT(summary["errors"]["position"]["max"], 1e-14);
}

TEST(Check, ResolvesAndEstimatesAndRunsNothing) {
  const TemporaryFolder folder;
  const auto outcome =
      mote({"check", MOTE_SCENARIOS "/gravity/trapezoid.yaml", "--set", "operator=mps"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("smoothing_length: 2"));
  EXPECT_THAT(outcome.output, HasSubstr("41 particles, 30000 steps, 11 snapshots"));
  EXPECT_THAT(outcome.output, HasSubstr("memory: about"));
}

TEST(List, NamesWhatAScenarioCanName) {
  EXPECT_THAT(mote({"list", "kernels"}).output, HasSubstr("cubic_spline"));
  EXPECT_THAT(mote({"list", "operators"}).output, HasSubstr("sph.truncated_gauss_cosine"));
  EXPECT_THAT(mote({"list", "models"}).output, HasSubstr("pressureless_gas"));
  EXPECT_THAT(mote({"list", "integrators"}).output, HasSubstr("runge_kutta_4"));
  EXPECT_THAT(mote({"list", "layouts"}).output, HasSubstr("sinusoidal"));
  EXPECT_THAT(mote({"list", "exact"}).output, HasSubstr("gravitating_sheets"));
  EXPECT_THAT(mote({"list", "scenarios"}).output,
              ContainsRegex("gravity/slab +Self-gravitating gas"));
}

TEST(Export, CsvHasSeventeenDigitsAndEveryField) {
  const TemporaryFolder folder;
  mote(run_arguments("gravity/trapezoid.yaml", folder / "out"));
  const auto csv = folder / "last.csv";
  const auto outcome = mote({"export", (folder / "out").string(), "--to", csv.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  const std::string text = read(csv);
  EXPECT_THAT(text,
              testing::StartsWith("id,x,velocity_x,density,mass,length,length_rate\n0,0.49914"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 42);
}

TEST(Export, FirstFrameIsTheStart) {
  const TemporaryFolder folder;
  mote(run_arguments("gravity/trapezoid.yaml", folder / "out"));
  const auto csv = folder / "first.csv";
  mote({"export", (folder / "out").string(), "--frame", "0", "--to", csv.string()});
  EXPECT_THAT(read(csv), HasSubstr("\n0,0.048780487804878"));
}

}  // namespace
}  // namespace mote::test
