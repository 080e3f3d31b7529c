#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "damped_swing.hpp"
#include "mote/app/command_line.hpp"
#include "mote/catalogue/catalogue.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

/// Runs a command in this process, with the model above in the catalogue; its exit code.
int command(const std::vector<std::string>& words) {
  Catalogue catalogue = standard_catalogue();
  catalogue.add_model<DampedSwingRecipe>();
  std::vector<const char*> arguments{"mote"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return command_line(catalogue, static_cast<int>(arguments.size()), arguments.data());
}

constexpr const char* scenario = R"(name: swing
dimension: 1
domain: {lower: [0], upper: [1]}
particles: {layout: regular, count: 5}
initial: {velocity: "1"}
model: {type: damped_swing}
operator: {family: sph, kernel: gauss}
time: {integrator: velocity_verlet, step: 0.05, end: 3}
output: {every: 0.7, picture: false}
)";

class AdaptiveSteps : public testing::Test {
 protected:
  AdaptiveSteps() : file_(write(folder_ / "swing.yaml", scenario)) {}

  int run(const std::string& out, const std::vector<std::string>& assignments = {}) {
    std::vector<std::string> words{"run", file_.string(), "--out", (folder_ / out).string(),
                                   "--quiet"};
    for (const std::string& assignment : assignments) {
      words.emplace_back("--set");
      words.push_back(assignment);
    }
    return command(words);
  }
  fs::path in(const std::string& name) const { return folder_ / name; }

  /// Numbers of a column of a run's history.
  std::vector<double> column(const std::string& out, std::size_t number) const {
    std::istringstream rows(read(in(out) / "history.csv"));
    std::vector<double> values;
    std::string row, cell;
    std::getline(rows, row);
    while (std::getline(rows, row)) {
      std::istringstream cells(row);
      for (std::size_t k = 0; k <= number; ++k) std::getline(cells, cell, ',');
      values.push_back(std::stod(cell));
    }
    return values;
  }

  TemporaryFolder folder_;
  fs::path file_;
};

TEST_F(AdaptiveSteps, HitEveryFrame) {
  ASSERT_EQ(run("out", {"output.history=1"}), 0);
  const auto series = nlohmann::json::parse(read(in("out/snapshots.hdf.series")));
  std::vector<double> times;
  for (const auto& file : series["files"]) times.push_back(file["time"]);
  EXPECT_EQ(times, (std::vector<double>{0, 0.7, 2 * 0.7, 3 * 0.7, 4 * 0.7, 3}));
}

TEST_F(AdaptiveSteps, FollowTheStateUpToTheLongestOfTheScenario) {
  ASSERT_EQ(run("out", {"output.history=1"}), 0);
  const auto times = column("out", 0), fastest = column("out", 3);
  ASSERT_GT(times.size(), 60);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double step = times[k + 1] - times[k];
    EXPECT_LE(step, std::min(0.05, 0.25 / (1 + 10 * fastest[k])) + 1e-15);
  }
  EXPECT_NEAR(times[1], 0.25 / 11, 1e-15);
}

TEST_F(AdaptiveSteps, AreNamedInTheHistoryWithWhatTheModelReads) {
  ASSERT_EQ(run("out"), 0);
  EXPECT_THAT(read(in("out/history.csv")),
              testing::StartsWith("time,step,count,fastest\n0,0,5,1\n"));
}

TEST_F(AdaptiveSteps, AreTheSameAfterARestart) {
  ASSERT_EQ(run("whole"), 0);
  fs::copy(in("whole"), in("cut"), fs::copy_options::recursive);
  for (const char* name :
       {"summary.json", "snapshots/000003.hdf", "snapshots/000004.hdf", "snapshots/000005.hdf"})
    fs::remove(in("cut") / name);
  ASSERT_EQ(command({"resume", in("cut").string(), "--quiet"}), 0);
  for (const char* name : {"snapshots/000003.hdf", "snapshots/000005.hdf", "history.csv"})
    EXPECT_EQ(read(in("cut") / name), read(in("whole") / name)) << name;
}

TEST_F(AdaptiveSteps, ThatCollapseAreAFailureThatSaysSo) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run("out", {"model.collapse=0.5", "initial.velocity='0'"}), 3);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::HasSubstr("the state allows no step beyond"));
}

}  // namespace
}  // namespace mote::test
