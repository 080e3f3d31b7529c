// Input that is right and a run that breaks down: exit code 3, and all that is needed to see why.

#include <regex>

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// A numerical failure as its message tells it.
struct Failure {
  long step = 0;
  double time = 0;
  long first = 0, second = 0;
  std::string likely_cause, last_good_snapshot;
};

Failure failure_in(const std::string& errors) {
  static const std::regex form(
      R"(\w+: numerical failure at step (\d+), t = (\S+): particles (\d+) and (\d+) crossed at )"
      R"(x = \S+\. Likely cause: (.+)\. Particles there: .+\. Last good snapshot: (\S+)\n)");
  std::smatch match;
  if (!std::regex_match(errors, match, form)) {
    ADD_FAILURE() << "this is not the message of a crossing: " << errors;
    return {};
  }
  return {std::stol(match[1]),
          std::stod(match[2]),
          std::stol(match[3]),
          std::stol(match[4]),
          match[5],
          match[6]};
}

/// The summary and the report are there and say that the run did not pass.
void expect_failed_certificate(const Workspace& workspace, const Outcome& outcome) {
  const std::string summary = read(workspace / "out/summary.json");
  EXPECT_NE(summary.find("\"passed\": false"), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"failure\": \"step "), std::string::npos) << summary;
  EXPECT_NE(read(workspace / "out/report.md").find("Last good snapshot: "), std::string::npos);
  EXPECT_EQ(outcome.output.find("passed"), std::string::npos) << outcome.output;
}

/// The snapshot that a message names can be read.
void expect_readable(const Workspace& workspace, const std::string& snapshot) {
  EXPECT_TRUE(fs::exists(workspace / snapshot)) << snapshot;
  const std::string frame = fs::path(snapshot).stem().string();
  const Outcome outcome =
      workspace.mote({"export", "out", "--frame", frame, "--to", "last_good.csv"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(read(workspace / "last_good.csv").find("nan"), std::string::npos);
}

class PrintedGravity : public testing::TestWithParam<std::string> {};

/// The printed gradient of the potential makes sheets cross between t = 1.2 and 3.1.
TEST_P(PrintedGravity, Crosses) {
  const Workspace workspace(read(MOTE_SCENARIOS "/gravity/" + GetParam() + ".yaml"));
  const Outcome outcome = workspace.mote(running(
      {"--out", "out", "--set", "output.picture=false", "--set", "model.gravity_form=potential"}));
  const Refusal refusal{GetParam() + ": numerical failure at step ", "gravity_form: sheets", 3};
  for (const auto& fault : faults(outcome, refusal)) ADD_FAILURE() << fault;
  const Failure failure = failure_in(outcome.errors);
  EXPECT_GT(failure.time, 1.2);
  EXPECT_LT(failure.time, 3.1);
  EXPECT_NEAR(failure.time, 0.00025 * static_cast<double>(failure.step), 1e-4);
  EXPECT_EQ(failure.second, failure.first + 1);
  EXPECT_LT(failure.second, 41);
  EXPECT_NE(failure.likely_cause, "");
  expect_failed_certificate(workspace, outcome);
  expect_readable(workspace, failure.last_good_snapshot);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, PrintedGravity,
                         testing::Values("trapezoid", "rectangle", "slab"),
                         [](const auto& info) { return info.param; });

/// The negative control: gravity from the sheets runs to the end of the same scenarios.
TEST_P(PrintedGravity, DoesNotCrossInTheGravityOfSheets) {
  const Workspace workspace(read(MOTE_SCENARIOS "/gravity/" + GetParam() + ".yaml"));
  const Outcome outcome =
      workspace.mote(running({"--out", "out", "--set", "output.picture=false"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

/// A good scenario that breaks down as it runs.
struct FailureCase {
  std::string label, text, sentence, cause;

  friend std::ostream& operator<<(std::ostream& out, const FailureCase& c) {
    return out << c.label;
  }
};

class BreakDown : public testing::TestWithParam<FailureCase> {};

TEST_P(BreakDown, IsTold) {
  const Workspace workspace(GetParam().text);
  const auto arguments = running({"--out", "out", "--quiet"});
  const Outcome outcome = workspace.mote(arguments);
  const Refusal refusal{"base: numerical failure at step ", GetParam().sentence, 3};
  for (const auto& fault : faults(outcome, refusal)) ADD_FAILURE() << fault;
  EXPECT_EQ(outcome.output, "");
  const auto cause = outcome.errors.find("Likely cause: ");
  const auto snapshot = outcome.errors.find("Last good snapshot: ");
  ASSERT_TRUE(cause != std::string::npos && snapshot != std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find(GetParam().cause, cause), std::string::npos) << outcome.errors;
  expect_failed_certificate(workspace, outcome);
  std::string name = outcome.errors.substr(snapshot + std::string("Last good snapshot: ").size());
  name.pop_back();
  expect_readable(workspace, name);
}

const std::string unchecked = "  against: nothing";

const std::vector<FailureCase> break_downs{
    {"falls_together", lines({{11, "time: {step: 0.01, end: 20}"}, {14, unchecked}, {15, ""}}),
     "collapsed at x = ", "a pressureless gas has no solution beyond this time"},
    {"thrown_together", lines({{8, "  velocity: \"x < 2 ? 1 : -1\""}, {14, unchecked}, {15, ""}}),
     "t = ", "a pressureless gas has no solution beyond this time"}};
INSTANTIATE_TEST_SUITE_P(Table, BreakDown, testing::ValuesIn(break_downs), by_label);

/// Going on from the last good snapshot ends at the same place with the same message.
TEST(BrokenRun, BreaksAgainAfterResume) {
  const Workspace workspace(
      lines({{11, "time: {step: 0.01, end: 20}"}, {14, unchecked}, {15, ""}}));
  const Outcome first = workspace.mote(running({"--out", "out", "--quiet"}));
  const Outcome again = workspace.mote({"resume", "out", "--quiet"});
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_EQ(again.errors, first.errors);
}

}  // namespace
}  // namespace mote::test
