// The viscous gas from the command line: limits of explicit steps, --strict, and the same bits
// across threads and a restart.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mote::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::vector<std::string> burgers(const fs::path& out, std::vector<std::string> assignments,
                                 const std::vector<std::string>& options = {}) {
  assignments.emplace_back("time.end=0.5");
  auto arguments = run_arguments("viscous/burgers.yaml", out, assignments);
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

// dx^2/(2 nu) of three points is 0.238 at the start.
const std::vector<std::string> beyond_limit{"model.viscosity_scheme=explicit", "time.step=0.25",
                                            "check=nothing"};

TEST(ExplicitViscosity, WarnsOfAStepBeyondTheLimitAndRuns) {
  const TemporaryFolder folder;
  const auto outcome = mote(burgers(folder / "out", beyond_limit));
  EXPECT_NE(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("time.step=0.25: warning: the step 0.25 is beyond the "
                                        "stability limit 0.238"));
  EXPECT_TRUE(fs::exists(folder / "out/summary.json"));
}

TEST(ExplicitViscosity, BeyondTheLimitIsBadInputWithStrict) {
  const TemporaryFolder folder;
  const auto outcome = mote(burgers(folder / "out", beyond_limit, {"--strict"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("time.step=0.25: the step 0.25 is beyond the stability "
                                        "limit 0.238"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ExplicitViscosity, WithinTheLimitSaysNothing) {
  const TemporaryFolder folder;
  const auto outcome = mote(
      burgers(folder / "out", {"model.viscosity_scheme=explicit", "time.step=0.01"}, {"--strict"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

/// The limit falls with the square of the shortest distance: from 0.238 to 1.4e-5 in this case.
const std::vector<std::string> passing{"model.viscosity_scheme=explicit", "time.step=0.002",
                                       "check=nothing"};

TEST(ExplicitViscosity, NotesWhenTheLimitIsPassedInTheRun) {
  const TemporaryFolder folder;
  auto arguments = burgers(folder / "out", passing);
  arguments.insert(arguments.end(), {"--set", "time.end=2.5"});
  const auto outcome = mote(arguments);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.errors;
  EXPECT_THAT(outcome.errors, HasSubstr("on the step 0.002 was beyond the stability limit"));
  const json summary = json::parse(read(folder / "out/summary.json"));
  EXPECT_THAT(summary["failure"].get<std::string>(),
              testing::AllOf(HasSubstr("crossed"), HasSubstr("implicit has none")));
  EXPECT_THAT(summary["warnings"].dump(), HasSubstr("beyond the stability limit"));
}

TEST(ExplicitViscosity, StopsWhenTheLimitIsPassedWithStrict) {
  const TemporaryFolder folder;
  auto arguments = burgers(folder / "out", passing, {"--strict"});
  arguments.insert(arguments.end(), {"--set", "time.end=2.5"});
  const auto outcome = mote(arguments);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.errors, HasSubstr("--strict makes an error of this warning"));
}

TEST(Viscosity, HasTheSameBitsForAnyNumberOfThreadsAndAfterAResume) {
  for (const std::string scheme : {"implicit", "substepped", "explicit"}) {
    const TemporaryFolder folder;
    const std::vector<std::string> assignments{
        "particles.count=4100", "operator=least_squares.2", "model.viscosity_scheme=" + scheme,
        "model.viscosity=1e-6", "time.step=0.025",          "check=nothing"};
    const auto one = folder / "one", two = folder / "two", resumed = folder / "resumed";
    mote(burgers(one, assignments, {"--threads", "1"}));
    mote(burgers(two, assignments, {"--threads", "2"}));
    fs::copy(one, resumed, fs::copy_options::recursive);
    fs::remove(resumed / "summary.json");
    fs::remove(resumed / "snapshots/000002.hdf");
    EXPECT_EQ(mote({"resume", resumed.string(), "--quiet"}).exit_code, 0);
    const std::string last = read(one / "snapshots/000002.hdf");
    EXPECT_FALSE(last.empty());
    EXPECT_TRUE(last == read(two / "snapshots/000002.hdf")) << scheme;
    EXPECT_TRUE(last == read(resumed / "snapshots/000002.hdf")) << scheme;
    EXPECT_FALSE(last == read(one / "snapshots/000001.hdf"));
  }
}

}  // namespace
}  // namespace mote::test
