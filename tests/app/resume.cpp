#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "support/program.hpp"

namespace mote::test {
namespace {

/// A run that takes a second or so and uses the operator: enough particles for several threads.
const std::vector<std::string> long_run{"particles.count=5000", "model.density=continuity",
                                        "time.end=0.1",         "time.step=0.0005",
                                        "output.every=0.0025",  "output.history=3"};

std::vector<std::string> long_arguments(const fs::path& out, int threads) {
  auto arguments = run_arguments("gravity/trapezoid.yaml", out, long_run);
  arguments.insert(arguments.end(), {"--threads", std::to_string(threads), "--quiet"});
  return arguments;
}

/// Two runs are the same if all their snapshots, their times and their history are.
void expect_same_results(const fs::path& a, const fs::path& b) {
  for (int frame = 0; frame <= 40; ++frame) {
    const auto name = fs::path("snapshots") /
                      (std::string(frame < 10 ? "00000" : "0000") + std::to_string(frame) + ".hdf");
    ASSERT_TRUE(fs::exists(a / name)) << name;
    EXPECT_TRUE(read(a / name) == read(b / name)) << name;
  }
  EXPECT_EQ(read(a / "history.csv"), read(b / "history.csv"));
  EXPECT_EQ(read(a / "snapshots.hdf.series"), read(b / "snapshots.hdf.series"));
}

class SameBits : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    mote(long_arguments(whole(), 1));
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path whole() { return *folder_ / "whole"; }
  static const TemporaryFolder& folder() { return *folder_; }

 private:
  static TemporaryFolder* folder_;
};
TemporaryFolder* SameBits::folder_ = nullptr;

TEST_F(SameBits, WithTwoAndFourThreads) {
  for (const int threads : {2, 4}) {
    const auto out = folder() / ("threads" + std::to_string(threads));
    mote(long_arguments(out, threads));
    expect_same_results(whole(), out);
  }
}

TEST_F(SameBits, AfterAKillAtAnyMomentAndAResume) {
  std::mt19937 random(7);
  for (const int frame : {1, 9, 30}) {
    const auto out = folder() / ("killed" + std::to_string(frame));
    const Program program(long_arguments(out, 2));
    const std::string name = (frame < 10 ? "00000" : "0000") + std::to_string(frame) + ".hdf";
    ASSERT_TRUE(wait_for_file(out / "snapshots" / name));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
    program.kill();
    EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL) << "the run ended before it was killed";
    EXPECT_FALSE(fs::exists(out / "summary.json"));
    const auto outcome = mote({"resume", out.string(), "--threads", "1", "--quiet"});
    EXPECT_LE(outcome.exit_code, 1) << outcome.errors;
    EXPECT_TRUE(fs::exists(out / "summary.json"));
    expect_same_results(whole(), out);
  }
}

TEST_F(SameBits, WhenAFinishedRunIsResumed) {
  const auto out = folder() / "finished";
  fs::copy(whole(), out, fs::copy_options::recursive);
  fs::remove(out / "summary.json");
  mote({"resume", out.string(), "--quiet"});
  expect_same_results(whole(), out);
  EXPECT_TRUE(fs::exists(out / "summary.json"));
}

TEST_F(SameBits, WhenSeriesAndTheLastHistoryRowAreDamaged) {
  const auto out = folder() / "damaged";
  fs::copy(whole(), out, fs::copy_options::recursive);
  fs::remove(out / "summary.json");
  fs::remove(out / "snapshots/000040.hdf");
  write(out / "snapshots.hdf.series", "not JSON");
  const std::string history = read(out / "history.csv");
  write(out / "history.csv", history.substr(0, history.size() - 30));
  mote({"resume", out.string(), "--quiet"});
  expect_same_results(whole(), out);
}

/// Negative control: the comparison notices one step more or less.
TEST_F(SameBits, AreNotThoseOfAnotherStep) {
  const auto out = folder() / "other";
  auto arguments = long_arguments(out, 1);
  arguments.insert(arguments.end(), {"--set", "time.step=0.00025"});
  mote(arguments);
  EXPECT_NE(read(whole() / "snapshots/000040.hdf"), read(out / "snapshots/000040.hdf"));
}

TEST(Resume, OfACompleteRunChangesNothing) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  mote(run_arguments("gravity/slab.yaml", out));
  const std::string summary = read(out / "summary.json");
  const auto outcome = mote({"resume", out.string()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, testing::HasSubstr("this run is complete"));
  EXPECT_EQ(read(out / "summary.json"), summary);
}

TEST(Resume, IsKeptOutOfARunThatIsGoingOn) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const Program program(long_arguments(out, 1));
  ASSERT_TRUE(wait_for_file(out / "snapshots/000002.hdf"));
  const auto outcome = mote({"resume", out.string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("another run is writing into this folder"));
  EXPECT_LE(program.wait().exit_code, 1);
}

TEST(Resume, LeavesNoUnfinishedFiles) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  {
    const Program program(long_arguments(out, 1));
    ASSERT_TRUE(wait_for_file(out / "snapshots/000003.hdf"));
    program.kill();
    program.wait();
  }
  mote({"resume", out.string(), "--quiet"});
  for (const auto& entry : fs::recursive_directory_iterator(out))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

}  // namespace
}  // namespace mote::test
