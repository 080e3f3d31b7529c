#include "mote/app/history_checks.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mote/particles/failure.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* history =
    "time,step,energy,toe,gap\n"
    "0,0,8,1,1\n"
    "1,10,4,3,nan\n"
    "2,20,2,7,5\n";

std::vector<CheckResult> results_of(const HistoryCheck& check) {
  const TemporaryFolder folder;
  Scenario scenario;
  scenario.constants = {{"E0", 8}};
  scenario.check.history = {check};
  return history_results(scenario, write(folder / "history.csv", history));
}

double result_of(const HistoryCheck& check) { return results_of(check).at(0).value; }

TEST(HistoryChecks, TakeAValueAtTheEndOrBetweenRows) {
  EXPECT_NEAR(result_of({.quantity = "toe", .value = 8, .error = 1}), 1.0 / 8, 1e-15);
  EXPECT_NEAR(result_of({.quantity = "toe", .at = 1.25, .value = 5, .error = 1}), 1.0 / 5, 1e-15);
  EXPECT_EQ(result_of({.quantity = "toe", .at = 0, .value = 1, .error = 1}), 0);
}

TEST(HistoryChecks, TakeBounds) {
  const auto results = results_of({.quantity = "toe", .at = 1, .most = 2, .least = 2});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].value, 3);
  EXPECT_FALSE(results[0].passed());
  EXPECT_TRUE(results[1].passed());
  EXPECT_EQ(results[1].name, "toe at t = 1");
}

TEST(HistoryChecks, TakeAFormulaOverAllRows) {
  EXPECT_NEAR(result_of({.quantity = "energy", .formula = "E0*2^(-t)", .error = 1}), 0, 1e-15);
  EXPECT_NEAR(result_of({.quantity = "energy", .formula = "E0 - 3*t", .error = 1}), 0.2, 1e-15);
  EXPECT_NEAR(
      result_of(
          {.quantity = "energy", .formula = "E0 - 3*t", .relative_to = "largest", .error = 1}),
      1.0 / 8, 1e-15);
}

TEST(HistoryChecks, TakeAFormulaOverSomeRowsAndNeverOverNone) {
  const HistoryCheck check{.quantity = "energy", .formula = "E0 - 4*t", .error = 1};
  const auto error = [&](std::optional<double> from, std::optional<double> until) {
    HistoryCheck part = check;
    part.from = from;
    part.until = until;
    return result_of(part);
  };
  EXPECT_TRUE(std::isinf(error({}, {})));  // 2 against 0
  EXPECT_EQ(error({}, 1), 0);
  EXPECT_EQ(error(0.5, 1.5), 0);
  EXPECT_TRUE(std::isinf(error(2, {})));
  EXPECT_TRUE(std::isnan(error(0.4, 0.6)));
}

TEST(HistoryChecks, TakeARateOfDecay) {
  const double rate = std::log(2);
  EXPECT_NEAR(result_of({.quantity = "energy", .decay_rate = rate, .error = 1}), 0, 1e-15);
  EXPECT_NEAR(result_of({.quantity = "energy", .decay_rate = 2 * rate, .error = 1}), 0.5, 1e-15);
}

TEST(HistoryChecks, TakeACurveInItsOwnScalesAsFarAsTheRunGoes) {
  // x = 10 t, y = toe/2: points at t = 0.5 (1 against 0.8), 2 (3.5), and 3, which is not run.
  EXPECT_NEAR(result_of({.quantity = "toe",
                         .times = {5, 20, 30},
                         .values = {0.8, 3.5, 99},
                         .scale_time = 10,
                         .scale = 0.5,
                         .error = 1}),
              0.25, 1e-15);
}

TEST(HistoryChecks, TakeACurveOfAClockThatStartedEarlier) {
  // x = 10 t + 5, y = toe/2: points before the run, at t = 0.5 (1 against 0.8) and 1.5 (2.5).
  HistoryCheck check{.quantity = "toe",
                     .times = {3, 10, 20},
                     .values = {99, 0.8, 3},
                     .scale_time = 10,
                     .offset_time = 5,
                     .scale = 0.5,
                     .error = 1};
  EXPECT_NEAR(result_of(check), 0.25, 1e-15);
  check.from = 1;
  EXPECT_NEAR(result_of(check), 1.0 / 6, 1e-15);
  check.from = 1.6;
  EXPECT_TRUE(std::isnan(result_of(check)));  // nothing to hold
  check.from = {};
  check.offset_time = 0;
  EXPECT_NEAR(result_of(check), 1 - 0.8 / 99, 1e-15);
}

TEST(HistoryChecks, FailWhereTheQuantityHasNoValue) {
  for (const HistoryCheck& check : {HistoryCheck{.quantity = "gap", .at = 1, .most = 9},
                                    {.quantity = "gap", .formula = "1", .error = 100},
                                    {.quantity = "gap", .times = {1}, .values = {1}, .error = 9}})
    EXPECT_FALSE(results_of(check).at(0).passed());
}

TEST(HistoryChecks, RefuseUnknownColumnsWithAHint) {
  try {
    refuse_unknown_quantities({{.quantity = "toe"}, {.quantity = "enrgy"}}, {"toe", "energy"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "check.history.1.quantity");
    EXPECT_THAT(error.what(), HasSubstr("no column 'enrgy' (did you mean 'energy'?)"));
  }
}

/// A scenario that reads a curve beside it: a slab whose mass stays 1.7.
fs::path scenario_with_curve(const TemporaryFolder& folder) {
  write(folder / "curve.csv", "# a comment\nhours,kilograms\n0,1700\n1,1700\n");
  std::string text = read(MOTE_SCENARIOS "/gravity/slab.yaml");
  return write(folder / "scenario.yaml",
               text +
                   "  history:\n"
                   "    - {quantity: mass, file: curve.csv, x: hours, y: kilograms,\n"
                   "       scale: 1000, error: 0.1}\n");
}

TEST(HistoryChecks, AreInTheCertificateAlsoOfARunThatWentOn) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const auto run = mote({"run", scenario_with_curve(folder).string(), "--out", out, "--set",
                         "output.picture=false", "--set", "time.step=0.005"});
  EXPECT_NE(run.exit_code, 2) << run.errors;
  const json first = json::parse(read(folder / "out/summary.json"))["checks"];
  EXPECT_THAT(first.dump(), HasSubstr("mass, relative error to curve.csv"));
  fs::remove(folder / "curve.csv");
  fs::remove(folder / "out/summary.json");
  fs::remove(folder / "out/snapshots/000010.hdf");
  const auto resumed = mote({"resume", out});
  EXPECT_EQ(resumed.exit_code, run.exit_code) << resumed.errors;
  EXPECT_EQ(json::parse(read(folder / "out/summary.json"))["checks"], first);
}

}  // namespace
}  // namespace mote::test
