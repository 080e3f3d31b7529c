// Folders from which no run can go on. Each is the folder of a finished run with one thing broken.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

const std::string last_snapshot = "run/snapshots/000010.hdf";
const std::string too_long(300, 'a');

using Prepare = std::function<void(const Workspace&)>;

Prepare writing(const std::string& name, const std::string& text) {
  return [=](const Workspace& workspace) { write(workspace / name, text); };
}

Prepare removing(const std::string& name) {
  return [=](const Workspace& workspace) { fs::remove_all(workspace / name); };
}

/// Keeps so many hundredths of the last snapshot.
Prepare cutting(std::uintmax_t percent) {
  return [=](const Workspace& workspace) {
    const fs::path path = workspace / last_snapshot;
    fs::resize_file(path, fs::file_size(path) * percent / 100);
  };
}

/// Replaces a word of run.yaml that is there once.
Prepare replacing(const std::string& old_word, const std::string& new_word) {
  return [=](const Workspace& workspace) {
    std::string text = read(workspace / "run/run.yaml");
    const auto place = text.find(old_word);
    ASSERT_NE(place, std::string::npos);
    write(workspace / "run/run.yaml", text.replace(place, old_word.size(), new_word));
  };
}

void take_snapshot_of_another_scenario(const Workspace& workspace) {
  ASSERT_EQ(workspace.mote(setting("particles.count=40")).exit_code, 0);
  fs::copy_file(workspace / "out/snapshots/000010.hdf", workspace / last_snapshot,
                fs::copy_options::overwrite_existing);
}

void take_an_earlier_snapshot_for_the_last(const Workspace& workspace) {
  fs::copy_file(workspace / "run/snapshots/000003.hdf", workspace / last_snapshot,
                fs::copy_options::overwrite_existing);
}

void make_run_yaml_a_folder(const Workspace& workspace) {
  fs::remove(workspace / "run/run.yaml");
  fs::create_directory(workspace / "run/run.yaml");
}

void make_a_snapshot_a_folder(const Workspace& workspace) {
  fs::remove(workspace / last_snapshot);
  fs::create_directory(workspace / last_snapshot);
}

class BadResume : public testing::TestWithParam<CommandCase> {};
TEST_P(BadResume, IsRefused) {
  const Workspace workspace;
  ASSERT_EQ(workspace.mote(running({"--out", "run"})).exit_code, 0);
  fs::create_directory(workspace / "empty");
  fs::remove(workspace / "run/summary.json");  // as if it had been killed just before its end
  GetParam().prepare(workspace);
  ASSERT_FALSE(HasFatalFailure());
  workspace.expect_refusal(GetParam().arguments, {GetParam().beginning, GetParam().sentence});
}

CommandCase resuming(const std::string& label, const std::string& beginning,
                     const std::string& sentence, const Prepare& prepare) {
  return {label, {"resume", "run"}, beginning, sentence, prepare};
}

const std::vector<CommandCase> bad_folders{
    {"empty", {"resume", "empty"}, "mote: empty: ", "this is not the output of a run"},
    {"not_there", {"resume", "nowhere"}, "mote: nowhere: ", "there is no such folder"},
    {"a_file", {"resume", "scenario.yaml"}, "mote: scenario.yaml: ", "folder"},
    {"name_too_long", {"resume", too_long}, "mote: " + too_long, "folder"},
    {"threads_0", {"resume", "run", "--threads", "0"}, "mote: --threads: ", "0"},
    {"one_argument_too_many", {"resume", "run", "more"}, "mote: ", "more"}};
INSTANTIATE_TEST_SUITE_P(Folder, BadResume, testing::ValuesIn(bad_folders), by_label);

const std::string damaged = "this snapshot is damaged or not one of mote";
const std::string place_of_snapshot = "mote: " + last_snapshot + ": ";

const std::vector<CommandCase> bad_snapshots{
    resuming("none", "mote: run: ", "there is no snapshot", removing("run/snapshots")),
    resuming("empty", place_of_snapshot, damaged, cutting(0)),
    resuming("cut_after_10_percent", place_of_snapshot, damaged, cutting(10)),
    resuming("cut_after_50_percent", place_of_snapshot, damaged, cutting(50)),
    resuming("cut_after_99_percent", place_of_snapshot, damaged, cutting(99)),
    resuming("garbage", place_of_snapshot, damaged, writing(last_snapshot, "not a snapshot")),
    resuming("garbage_after_the_signature", place_of_snapshot, damaged,
             writing(last_snapshot, "\x89HDF\r\n\x1a\n" + std::string(5000, 'x'))),
    resuming("a_folder", place_of_snapshot, "damaged", make_a_snapshot_a_folder),
    resuming("of_another_scenario", place_of_snapshot, "belongs to another scenario than run.yaml",
             take_snapshot_of_another_scenario),
    resuming("of_another_frame", place_of_snapshot, "frame 3",
             take_an_earlier_snapshot_for_the_last)};
INSTANTIATE_TEST_SUITE_P(Snapshot, BadResume, testing::ValuesIn(bad_snapshots), by_label);

const std::vector<CommandCase> bad_run_files{
    resuming("not_there", "mote: run: ", "it has no run.yaml", removing("run/run.yaml")),
    resuming("empty", "run/run.yaml: ", "this file is empty", writing("run/run.yaml", "")),
    resuming("not_yaml", "run/run.yaml:1:7: ", "this is not YAML",
             writing("run/run.yaml", "name: ]")),
    resuming("a_folder", "run/run.yaml: ", "this is a folder, not a file", make_run_yaml_a_folder),
    resuming("key_misspelt", "run/run.yaml:25:3: ", "unknown key 'number'",
             replacing("count", "number")),
    resuming("other_count", place_of_snapshot, "belongs to another scenario",
             replacing("count: 41", "count: 42")),
    resuming("other_end", place_of_snapshot, "belongs to another scenario",
             replacing("end: 1\n", "end: 2\n"))};
INSTANTIATE_TEST_SUITE_P(RunFile, BadResume, testing::ValuesIn(bad_run_files), by_label);

const std::vector<CommandCase> bad_records{
    resuming("history_not_there", "mote: run/history.csv: ", "cannot read this file",
             removing("run/history.csv")),
    resuming("history_empty", "mote: run/history.csv: ", "damaged", writing("run/history.csv", "")),
    resuming("history_of_garbage", "mote: run/history.csv: ", "damaged",
             writing("run/history.csv", "not a table\n"))};
INSTANTIATE_TEST_SUITE_P(Record, BadResume, testing::ValuesIn(bad_records), by_label);

/// A byte of the last snapshot, anywhere in what describes the state, has another value: mote may
/// take it or not, but it says so.
TEST(DamagedByte, DoesNotCrashMote) {
  const Workspace workspace;
  ASSERT_EQ(workspace.mote(running({"--out", "run"})).exit_code, 0);
  const std::string good = read(workspace / last_snapshot);
  const auto start = good.find(std::string("step\0", 5));
  ASSERT_NE(start, std::string::npos);
  for (std::size_t place = start; place < start + 64; ++place) {
    std::string damaged_text = good;
    damaged_text[place] = static_cast<char>(damaged_text[place] ^ 0x80);
    write(workspace / last_snapshot, damaged_text);
    const Outcome outcome = workspace.mote({"export", "run", "--to", "a.csv", "--overwrite"});
    if (outcome.exit_code == 0) continue;
    for (const auto& fault : faults(outcome, {place_of_snapshot, damaged}))
      ADD_FAILURE() << "byte " << place - start << ": " << fault;
  }
}

/// The control: the folder as the run left it has nothing more to do.
TEST(GoodResume, EndsWithoutAWord) {
  const Workspace workspace;
  ASSERT_EQ(workspace.mote(running({"--out", "run"})).exit_code, 0);
  const Outcome outcome = workspace.mote({"resume", "run"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace mote::test
