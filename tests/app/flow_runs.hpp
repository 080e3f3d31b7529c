#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace mote::test {

/// Files that hold the states of a run.
inline const std::vector<std::string> frames{"snapshots/000000.hdf", "snapshots/000001.hdf",
                                             "snapshots/000002.hdf", "snapshots/000003.hdf",
                                             "snapshots/000004.hdf"};

/// The rows of history.csv, but for the share of time that a solver took: that is another one in
/// every run.
inline std::string history_of(const fs::path& out) {
  std::istringstream lines(read(out / "history.csv"));
  std::string line, cell, kept;
  std::ptrdiff_t left_out = -1;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (std::ptrdiff_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (cell == "solver_share") left_out = k;
      if (k != left_out) kept += cell + ',';
    }
    kept += '\n';
  }
  return kept;
}

/// Runs of a flow with five frames, whole and resumed.
class FlowRuns : public testing::Test {
 protected:
  fs::path run(const std::string& scenario, const std::string& out,
               const std::vector<std::string>& more = {}) const {
    write(folder_ / "scenario.yaml", scenario);
    std::vector<std::string> words{"run", (folder_ / "scenario.yaml").string(), "--out",
                                   (folder_ / out).string(), "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = mote(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return folder_ / out;
  }

  /// The same run, cut after its second snapshot and resumed.
  fs::path resumed(const fs::path& whole, const std::string& out,
                   const std::string& threads) const {
    fs::copy(whole, folder_ / out, fs::copy_options::recursive);
    for (const char* name : {"summary.json", "snapshots/000003.hdf", "snapshots/000004.hdf"})
      fs::remove(folder_ / out / name);
    const Outcome outcome =
        mote({"resume", (folder_ / out).string(), "--threads", threads, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return folder_ / out;
  }

  static void expect_same(const fs::path& a, const fs::path& b) {
    EXPECT_EQ(history_of(a), history_of(b));
    for (const std::string& name : frames) {
      ASSERT_TRUE(fs::exists(a / name) && fs::exists(b / name)) << name;
      EXPECT_TRUE(read(a / name) == read(b / name)) << name;
    }
  }

  void expect_same_bits_for_any_number_of_threads(const std::string& scenario) const {
    const fs::path one = run(scenario, "one", {"--threads", "1"});
    expect_same(one, run(scenario, "two", {"--threads", "2"}));
    expect_same(one, run(scenario, "four", {"--threads", "4"}));
  }

  void expect_same_bits_after_a_resume(const std::string& scenario,
                                       const std::vector<std::string>& threads) const {
    const fs::path whole = run(scenario, "whole", {"--threads", "2"});
    for (const std::string& count : threads)
      expect_same(whole, resumed(whole, "resumed" + count, count));
  }

  TemporaryFolder folder_;
};

}  // namespace mote::test
