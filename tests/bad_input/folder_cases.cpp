// Output folders of a run: what is there stays as it was.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

const std::string too_long(300, 'a');

void make_file(const Workspace& workspace) { write(workspace / "file", "text"); }

void make_folder_with_notes(const Workspace& workspace) {
  fs::create_directories(workspace / "notes/snapshots");
  write(workspace / "notes/summary.json", "mine");
  write(workspace / "notes/snapshots/000000.hdf", "mine");
}

/// A folder of another program, whose file happens to have the name of one of ours.
void make_foreign_folder(const Workspace& workspace) {
  make_folder_with_notes(workspace);
  write(workspace / "notes/run.yaml", "steps: [build, test]\n");
}

void make_run(const Workspace& workspace) {
  ASSERT_EQ(workspace.mote(running({"--out", "run"})).exit_code, 0);
}

/// The user's scenario has the name that a run gives to its own.
void make_scenario_named_run(const Workspace& workspace) {
  fs::create_directory(workspace / "case");
  write(workspace / "case/run.yaml", "# A comment that took me an hour.\n" + lines({}));
}

void make_results_a_file(const Workspace& workspace) { write(workspace / "results", "text"); }

class BadFolder : public testing::TestWithParam<CommandCase> {};
TEST_P(BadFolder, StaysAsItWas) {
  const Workspace workspace;
  GetParam().prepare(workspace);
  ASSERT_FALSE(HasFatalFailure());
  workspace.expect_refusal(GetParam().arguments, {GetParam().beginning, GetParam().sentence});
}

const std::vector<CommandCase> bad_folders{
    {"not_empty", running({"--out", "notes"}),
     "mote: notes: ", "this folder exists and is not empty", make_folder_with_notes},
    {"former_run", running({"--out", "run"}), "mote: run: ", "--overwrite replaces a former run",
     make_run},
    {"that_of_the_scenario", running({"--out", "."}),
     "mote: .: ", "this folder exists and is not empty"},
    {"overwrite_of_no_run", running({"--out", "notes", "--overwrite"}), "mote: notes: ",
     "this folder is not the output of a run, so it is not overwritten", make_folder_with_notes},
    {"overwrite_of_a_foreign_run", running({"--out", "notes", "--overwrite"}), "mote: notes: ",
     "this folder is not the output of a run, so it is not overwritten", make_foreign_folder},
    {"overwrite_of_the_scenario",
     {"run", "case/run.yaml", "--out", "case", "--overwrite"},
     "mote: case: ",
     "not overwritten",
     make_scenario_named_run},
    {"overwrite_by_a_bad_scenario",
     running({"--out", "run", "--overwrite", "--set", "particles.count=1"}),
     "--set particles.count=1: ", "'count' must be from 2", make_run},
    {"is_a_file", running({"--out", "file"}), "mote: file: ", "this is a file, not a folder",
     make_file},
    {"is_a_file_to_overwrite", running({"--out", "file", "--overwrite"}),
     "mote: file: ", "this is a file, not a folder", make_file},
    {"is_the_scenario", running({"--out", "scenario.yaml", "--overwrite"}),
     "mote: scenario.yaml: ", "this is a file, not a folder"},
    {"below_a_file", running({"--out", "file/out"}), "mote: file/out", "Not a directory",
     make_file},
    {"without_name", running({"--out", ""}), "mote: ", "--out"},
    {"with_too_long_a_name", running({"--out", too_long}), "mote: " + too_long, "too long"},
    {"results_is_a_file",
     {"run", "scenario.yaml"},
     "mote: results/base",
     "Not a directory",
     make_results_a_file}};
INSTANTIATE_TEST_SUITE_P(Table, BadFolder, testing::ValuesIn(bad_folders), by_label);

/// The control: the same folder, asked for rightly, is replaced.
TEST(GoodFolder, IsOverwrittenWhenAsked) {
  const Workspace workspace;
  make_run(workspace);
  write(workspace / "run/notes.txt", "mine");
  const Outcome outcome = workspace.mote(running({"--out", "run", "--overwrite"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_EQ(read(workspace / "run/notes.txt"), "mine");
}

}  // namespace
}  // namespace mote::test
