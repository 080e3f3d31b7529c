#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Names = std::vector<std::string>;

const std::string well =
    "name: well\ndomain: {lower: [0], upper: [1]}\nparticles: {count: 2}\n"
    "model: {type: schroedinger, potential: infinite_well, states: 2}\n"
    "check: {energies: [0.0133, 0.064]}\noutput: {picture: false}\n";

/// A folder with a model without time, which mote solves there.
struct Place : TemporaryFolder {
  Outcome solve(const Names& more = {}) const {
    write(*this / "well.yaml", well);
    Names arguments{"run", (*this / "well.yaml").string(), "--out", (*this / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mote(arguments);
  }
  std::string file(const std::string& name) const { return read(*this / "out" / name); }
};

TEST(Stationary, LeavesEnergiesWaveFunctionsAndAReport) {
  const Place place;
  EXPECT_EQ(place.solve().exit_code, 0);
  EXPECT_THAT(place.file("eigenvalues.csv"), StartsWith("state,energy,exact,relative_error\n1,10"));
  EXPECT_THAT(place.file("wave_functions.csv"), StartsWith("x,psi_1,psi_2,exact_1,exact_2\n0,0,"));
  EXPECT_THAT(place.file("report.md"), HasSubstr("| 2 | 42 | 39.4784176044 | 6.39e-02 |"));
  EXPECT_TRUE(nlohmann::json::parse(place.file("summary.json"))["passed"]);
}

TEST(Stationary, FailsWhereALimitDoesNotHold) {
  const Place place;
  EXPECT_EQ(place.solve({"--set", "check.energies=[0.0131]"}).exit_code, 1);
  EXPECT_THAT(place.file("report.md"), HasSubstr("**A check failed.**"));
}

/// No sentence but one, and no result.
TEST(Stationary, FailsWhereNumbersDoNotSuffice) {
  const Names oscillator{"--set", "model.potential=harmonic_oscillator", "--set", "check={}"};
  const auto solve = [&](bool well, const std::string& assignment) {
    Names arguments{"--set", "check={}"};
    if (!well) arguments = oscillator;
    arguments.insert(arguments.end(), {"--set", assignment});
    const Place place;
    const Outcome outcome = place.solve(arguments);
    EXPECT_FALSE(fs::exists(place / "out")) << assignment;
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("Likely cause: ")) << assignment;
    return outcome.exit_code;
  };
  for (const char* decay : {"model.decay=1e200", "model.decay=1e-200"})
    EXPECT_EQ(solve(false, decay), 3) << decay;
  EXPECT_EQ(solve(false, "domain={lower: [-1e-160], upper: [1e-160]}"), 3);
  EXPECT_EQ(solve(true, "domain.upper=[1e200]"), 3);
  EXPECT_EQ(solve(true, "domain.upper=[1e-200]"), 3);
}

TEST(Stationary, SaysWhichStatesAreNotBound) {
  const Place place;
  const Names coulomb{"--set", "model.potential=coulomb", "--set", "particles.count=9",
                      "--set", "check.energies=[5e-10]"};
  const Outcome outcome = place.solve(coulomb);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.errors, StartsWith("well: warning: state 2 with E = 6.78783 is not bound: "));
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
  EXPECT_THAT(place.file("report.md"), HasSubstr("is not bound"));
  EXPECT_THAT(place.file("summary.json"), HasSubstr("is not bound"));
  Names strict = coulomb;
  strict.insert(strict.end(), {"--strict", "--overwrite"});
  EXPECT_EQ(place.solve(strict).exit_code, 2);
}

TEST(Stationary, WarnsNotOfStatesThatAreBound) {
  const Place place;
  EXPECT_EQ(place.solve().errors, "");
  EXPECT_EQ(place
                .solve({"--set", "model.potential=harmonic_oscillator", "--set",
                        "domain={lower: [-5], upper: [5]}", "--set", "particles.count=33", "--set",
                        "model.states=20", "--set", "check={}", "--overwrite"})
                .errors,
            "");
}

TEST(Stationary, ComparesWithNothingIfToldSo) {
  const Place place;
  EXPECT_EQ(place.solve({"--set", "check=nothing"}).exit_code, 0);
  EXPECT_THAT(place.file("eigenvalues.csv"), StartsWith("state,energy\n1,10"));
  EXPECT_EQ(nlohmann::json::parse(place.file("summary.json"))["against"], "nothing");
  EXPECT_THAT(place.solve({"--set", "check=foo"}).errors,
              HasSubstr("unknown against 'foo'; there are: exact, nothing"));
}

TEST(Stationary, RefusesWhatDoesNotFit) {
  const Place place;
  EXPECT_THAT(place.solve({"--set", "model.states=3"}).errors,
              HasSubstr("2 nodes have 2 states, and not 3"));
  EXPECT_THAT(
      place.solve({"--set", "model.potential=coulomb", "--set", "domain.lower=[0.5]"}).errors,
      HasSubstr("the domain must start"));
  for (const char* variable : {"y", "z", "r", "t"}) {
    const std::string formula = std::string("model.formula=x + ") + variable;
    EXPECT_THAT(place.solve({"--set", "model.potential=formula", "--set", formula}).errors,
                HasSubstr(std::string("a formula in x alone, and this names ") + variable));
  }
  EXPECT_THAT(place.solve({"--set", "time.end=1"}).errors, HasSubstr("unknown key 'time'"));
}

}  // namespace
}  // namespace mote::test
