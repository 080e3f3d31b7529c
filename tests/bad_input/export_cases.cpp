// Exports that cannot be made: nothing is written, and nothing is left over.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

const std::string too_long(300, 'a');

/// The arguments of an export of the folder `run`.
std::vector<std::string> exporting(const std::string& to, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"export", "run", "--to", to});
  return more;
}

std::vector<std::string> exporting_frame(const std::string& frame) {
  return exporting("a.csv", {"--frame", frame});
}

void make_csv(const Workspace& workspace) { write(workspace / "a.csv", "mine"); }

void make_folder(const Workspace& workspace) { fs::create_directory(workspace / "a.csv"); }

void cut_last_snapshot(const Workspace& workspace) {
  fs::resize_file(workspace / "run/snapshots/000010.hdf", 5000);
}

void remove_snapshots(const Workspace& workspace) { fs::remove_all(workspace / "run/snapshots"); }

class BadExport : public testing::TestWithParam<CommandCase> {};
TEST_P(BadExport, IsRefused) {
  const Workspace workspace;
  ASSERT_EQ(workspace.mote(running({"--out", "run"})).exit_code, 0);
  GetParam().prepare(workspace);
  workspace.expect_refusal(GetParam().arguments, {GetParam().beginning, GetParam().sentence});
}

const std::vector<CommandCase> bad_exports{
    {"frame_missing", exporting_frame("99"), "mote: --frame 99: ", "there are the frames 0 to 10"},
    {"frame_negative", exporting_frame("-1"), "mote: --frame -1: ", "there are the frames 0 to 10"},
    {"frame_in_words", exporting_frame("first"), "mote: --frame first: ", "a number or 'last'"},
    {"frame_empty", exporting_frame(""), "mote: --frame ", "a number or 'last'"},
    {"frame_fraction", exporting_frame("1.5"), "mote: --frame 1.5: ", "a number or 'last'"},
    {"frame_huge", exporting_frame("99999999999999999999"), "mote: --frame ", "number"},
    {"extension_unknown", exporting("a.txt"), "mote: --to a.txt: ", "must end in .csv or .vtp"},
    {"extension_none", exporting("a"), "mote: --to a: ", "must end in .csv or .vtp"},
    {"file_without_name", exporting(""), "mote: --to", "must end in .csv or .vtp"},
    {"file_not_given", {"export", "run"}, "mote: ", "--to is required"},
    {"file_exists", exporting("a.csv"), "mote: a.csv: ", "this file exists", make_csv},
    {"file_in_no_folder", exporting("nowhere/a.csv"), "mote: nowhere/a.csv: ", "cannot write"},
    {"file_below_a_file", exporting("scenario.yaml/a.csv"),
     "mote: scenario.yaml/a.csv: ", "cannot write"},
    {"file_is_a_folder", exporting("a.csv", {"--overwrite"}), "mote: a.csv: ", "this is a folder",
     make_folder},
    {"file_name_too_long", exporting(too_long + ".csv"), "mote: " + too_long, "cannot write"},
    {"folder_not_there",
     {"export", "nowhere", "--to", "a.csv"},
     "mote: nowhere: ",
     "there is no such folder"},
    {"folder_is_a_file",
     {"export", "scenario.yaml", "--to", "a.csv"},
     "mote: scenario.yaml: ",
     "folder"},
    {"folder_is_no_run",
     {"export", ".", "--to", "a.csv"},
     "mote: .: ",
     "this is not the output of a run"},
    {"folder_name_too_long", {"export", too_long, "--to", "a.csv"}, "mote: " + too_long, "folder"},
    {"snapshots_not_there", exporting("a.csv"), "mote: run: ", "there are no snapshots",
     remove_snapshots},
    {"snapshot_cut_off", exporting("a.csv"),
     "mote: run/snapshots/000010.hdf: ", "this snapshot is damaged", cut_last_snapshot}};
INSTANTIATE_TEST_SUITE_P(Table, BadExport, testing::ValuesIn(bad_exports), by_label);

/// The control: the same folder, asked for rightly, is exported.
TEST(GoodExport, WritesTheFile) {
  const Workspace workspace;
  ASSERT_EQ(workspace.mote(running({"--out", "run"})).exit_code, 0);
  const Outcome outcome = workspace.mote(exporting_frame("10"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(read(workspace / "a.csv").starts_with("id,x,"));
}

}  // namespace
}  // namespace mote::test
