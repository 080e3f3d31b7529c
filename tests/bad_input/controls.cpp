// The good scenario passes through the harness of the bad ones, and the harness can fail.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

const Refusal refusal{"scenario.yaml:5:1: ", "unknown key 'partcles'"};
const std::string message =
    "scenario.yaml:5:1: unknown key 'partcles' (did you mean 'particles'?) in the scenario\n";

TEST(GoodInput, RunsWithoutAWord) {
  const Workspace workspace;
  const Outcome outcome = workspace.mote({"run", "scenario.yaml", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_NE(read(workspace / "out/summary.json").find("\"passed\": true"), std::string::npos);
}

TEST(GoodInput, ChecksWithoutAWordAndWritesNothing) {
  const Workspace workspace;
  const Outcome outcome = workspace.mote({"check", "scenario.yaml"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_EQ(contents(workspace.path()).size(), 1u);
}

/// Everything but UTF-8 without a mark, and line ends other than ours.
TEST(GoodInput, MayComeFromOtherEditors) {
  std::string windows = "\xEF\xBB\xBF" + lines({});
  for (auto end = windows.find('\n'); end != std::string::npos; end = windows.find('\n', end + 2))
    windows.insert(end, 1, '\r');
  const Outcome outcome = Workspace(windows).mote({"check", "scenario.yaml"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

/// A value that another key changes is good, too: the step limit is for this gas, not a constant.
TEST(GoodInput, MayHaveNumbersAsExpressions) {
  const Workspace workspace;
  const Outcome outcome = workspace.mote(setting("time.step=L/100"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST(Harness, AcceptsTheRightAnswer) { EXPECT_TRUE(faults({2, "", message}, refusal).empty()); }

TEST(Harness, RefusesGoodInput) { EXPECT_FALSE(faults({0, "done\n", ""}, refusal).empty()); }

TEST(Harness, RefusesAWrongExitCode) { EXPECT_EQ(faults({1, "", message}, refusal).size(), 1u); }

TEST(Harness, RefusesAWrongPlace) {
  EXPECT_EQ(faults({2, "", message}, {"scenario.yaml:5:2: ", refusal.sentence}).size(), 1u);
}

TEST(Harness, RefusesAnotherSentence) {
  EXPECT_EQ(faults({2, "", message}, {refusal.beginning, "missing key"}).size(), 1u);
}

TEST(Harness, RefusesMoreThanOneLine) {
  EXPECT_EQ(faults({2, "", message + "more\n"}, refusal).size(), 1u);
  EXPECT_EQ(faults({2, "", message.substr(0, message.size() - 1)}, refusal).size(), 1u);
  EXPECT_EQ(faults({2, "", "scenario.yaml:5:1: \x1b[31munknown key 'partcles'\n"}, refusal).size(),
            1u);
}

TEST(Harness, RefusesAnythingOnStandardOutput) {
  EXPECT_EQ(faults({2, "one line\n", message}, refusal).size(), 1u);
}

TEST(Harness, RefusesACrash) {
  const Outcome crash{134, "", "terminate called after throwing an instance of 'x'\n what(): y\n"};
  EXPECT_GE(faults(crash, refusal).size(), 4u);
}

TEST(Harness, FindsThePlaceOfAMark) {
  const Marked marked = unmark(line(5, "particles: {layout: regular, count: @1}"));
  EXPECT_EQ(marked.text, line(5, "particles: {layout: regular, count: 1}"));
  EXPECT_EQ(marked.place, ":5:37");
  EXPECT_EQ(unmark(line(1, "@nam: base")).place, ":1:1");
  EXPECT_EQ(unmark(lines({})).place, "");
}

TEST(Harness, SeesChangesInAFolder) {
  const Workspace workspace;
  const Contents before = contents(workspace.path());
  EXPECT_TRUE(changed(before, contents(workspace.path())).empty());
  fs::create_directory(workspace / "out");
  EXPECT_EQ(changed(before, contents(workspace.path())), std::vector<std::string>{"out/ (new)"});
  write(workspace / "scenario.yaml", "other");
  EXPECT_EQ(changed(before, contents(workspace.path())).size(), 2u);
}

}  // namespace
}  // namespace mote::test
