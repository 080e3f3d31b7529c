// Whole runs and comparisons of orbits: exact solutions, collisions, errors in the history, bounds
// in all rows, and integrators that do not suit.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "study/csv_table.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using namespace std::string_literals;
using Names = std::vector<std::string>;

/// Two bodies on a tilted orbit of eccentricity 0.36 that drifts, from the furthest point on for
/// little more than the period 3.96; one has no mass.
const std::string pair =
    "name: pair\ndimension: 3\n"
    "model:\n  type: bodies\n  masses:\n"
    "    - {name: Sun, mass: 1, position: [1, 2, 3], velocity: [0.1, 0, -0.2], radius: 0.1}\n"
    "    - {name: Comet, mass: 0, position: [2, 2, 3], velocity: [0.1, 0.64, -0.68], "
    "radius: 0.2}\n"
    "time: {integrator: runge_kutta_4, step: 0.01, end: 4}\n"
    "output: {picture: false, errors: true, history: 1}\n"
    "check:\n  against: kepler\n  position: 1e-6\n  velocity: 1e-6\n  history:\n"
    "    - {quantity: position_error, most: 1e-6, throughout: true}\n"
    "    - {quantity: collisions, most: 0}\n";

/// The same two as points, which do not collide.
std::string points() {
  std::string text = pair;
  for (const std::string& radius : {", radius: 0.1"s, ", radius: 0.2"s})
    text.erase(text.find(radius), radius.size());
  return text.erase(text.find("    - {quantity: collisions"));
}

/// The same two with radii that touch on their way, on which they are 0.47 apart at the least.
std::string touching() {
  std::string text = pair;
  return text.replace(text.find("radius: 0.2"), 11, "radius: 0.65");
}

struct Orbits : testing::Test {
  TemporaryFolder folder;

  Outcome run(const std::string& scenario, Names more = {}) const {
    write(folder / "scenario.yaml", scenario);
    Names arguments{"run", (folder / "scenario.yaml").string(), "--out", (folder / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mote(arguments);
  }
  Outcome compare(const std::string& scenario, Names more) const {
    write(folder / "scenario.yaml", scenario);
    Names arguments{"compare", (folder / "scenario.yaml").string(), "--out",
                    (folder / "compared").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mote(arguments);
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(read(folder / "out/summary.json"));
  }
};

TEST_F(Orbits, AreKeplersInSpace) {
  const Outcome outcome = run(pair);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
  EXPECT_THAT(outcome.errors, IsEmpty());
  const auto told = summary();
  EXPECT_EQ(told.at("operator"), "none");
  EXPECT_EQ(told.at("evaluations"), 400 * 4);
  EXPECT_LT(told.at("errors").at("position").at("l2"), 1e-7);
  EXPECT_GT(told.at("errors").at("position").at("l2"), 1e-13);  // it is not compared with itself
}

/// Negative controls: another motion, and a step that is too long on the way.
TEST_F(Orbits, AreNotThoseOfAnotherMethodOrStep) {
  EXPECT_EQ(run(pair, {"--set", "time.integrator=forward_euler"}).exit_code, 1);
  const Outcome coarse = run(pair, {"--overwrite", "--set", "time.step=0.1"});
  EXPECT_EQ(coarse.exit_code, 1);
  EXPECT_THAT(coarse.output, HasSubstr("position_error at all times"));
}

TEST_F(Orbits, TellTheirErrorsInEveryRow) {
  EXPECT_EQ(run(pair).exit_code, 0);
  const CsvTable history(read(folder / "out/history.csv"));
  EXPECT_EQ(history.rows.size(), 401u);
  EXPECT_LT(std::stod(history.rows.front().at("position_error")), 1e-15);
  EXPECT_DOUBLE_EQ(std::stod(history.rows.back().at("position_error")),
                   summary().at("errors").at("position").at("l2").get<double>());
}

/// Balls that touch on their way, and what a restart in between leaves of that.
TEST_F(Orbits, TellCollisions) {
  const Outcome outcome = run(touching());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("collision: Sun and Comet at t = "));
  ASSERT_TRUE(fs::exists(folder / "out/history.csv"));
  EXPECT_THAT(read(folder / "out/report.md"), HasSubstr("nothing merges or bounces"));
  const CsvTable whole(read(folder / "out/history.csv"));
  EXPECT_EQ(std::stod(whole.rows.back().at("collisions")), 1);
  for (const char* left : {"out/summary.json", "out/snapshots/000010.hdf"})
    fs::remove(folder / left);
  EXPECT_EQ(mote({"resume", (folder / "out").string()}).exit_code, 1);
  const CsvTable resumed(read(folder / "out/history.csv"));
  EXPECT_EQ(std::stod(resumed.rows.back().at("collisions")), 1);
}

TEST_F(Orbits, StopAtACollisionIfWarningsAreErrors) {
  const Outcome outcome = run(touching(), {"--strict"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.errors, HasSubstr("Sun and Comet"));
}

TEST_F(Orbits, ReturnToTheirStart) {
  const std::string circle =
      "name: circle\ndimension: 3\nmodel:\n  type: bodies\n  masses:\n"
      "    - {mass: 1, position: [0, 0, 0]}\n"
      "    - {mass: 0, position: [1, 0, 0], velocity: [0, 1, 0]}\n"
      "time: {integrator: runge_kutta_4, step: 0.01, end: 2*pi}\n"
      "output: {picture: false}\ncheck: {against: start, position: 1e-7, velocity: 1e-7}\n";
  EXPECT_EQ(run(circle).exit_code, 0);
  EXPECT_EQ(run(circle, {"--overwrite", "--set", "time.end=6"}).exit_code, 1);
}

TEST_F(Orbits, CompareIntegratorsByWorkAndTellWhichDoNotSuit) {
  const Outcome outcome =
      compare(points(), {"--vary", "time.integrator=velocity_verlet,runge_kutta_4", "--vary",
                         "time.dense_output=none,own", "--set", "check.history=[]"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, IsEmpty());
  const CsvTable table(read(folder / "compared/compare.csv"));
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[0].at("evaluations"), "401");
  EXPECT_EQ(table.rows[1].at("failure"),
            "velocity_verlet has no path of its own between the ends of its steps");
  EXPECT_EQ(table.rows[2].at("evaluations"), "1600");
  EXPECT_EQ(table.rows[3].at("passed"), "false");
  EXPECT_FALSE(fs::exists(folder / "compared" / table.rows[1].at("folder")));
  EXPECT_THAT(outcome.output, HasSubstr("no result: velocity_verlet has no path of its own"));
  EXPECT_THAT(outcome.output, HasSubstr("angular_momentum drift"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("angular_momentum_x drift")));
}

TEST_F(Orbits, CompareNothingIfNoIntegratorSuits) {
  const Outcome outcome = compare(pair, {"--vary", "time.dense_output=own"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("(in the member time.dense_output = own)"));
  EXPECT_FALSE(fs::exists(folder / "compared"));
}

}  // namespace
}  // namespace mote::test
