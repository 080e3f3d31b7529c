// mote compare from end to end: folders, rows that fail, expectations, exit codes.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "study/csv_table.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Names = std::vector<std::string>;

/// A slab in which sheets cross at t = 1.27 if gravity is the printed gradient of the potential.
const std::string slab =
    "name: slab\ndimension: 1\nconstants: {L: 4, G: 0.0015}\ndomain: {lower: [0], upper: [L]}\n"
    "particles: {count: 41}\n"
    "initial: {density: \"x >= 0.35*L && x < 0.75*L ? 1.025 : 0.025\"}\n"
    "model: {type: pressureless_gas, gravity: G}\noperator: sph.gauss\n"
    "time: {integrator: symplectic_euler, step: 0.01, end: 2}\n"
    "output: {every: 1, picture: false}\n"
    "check: {against: gravitating_sheets, velocity: 1e-12}\n";

const std::string crossing =
    "compare:\n  vary: {model.gravity_form: [sheets, potential], particles.count: [21, 41]}\n"
    "  expect:\n"
    "    - {select: {model.gravity_form: potential}, fails_after: 1.2, fails_before: 1.9}\n"
    "    - {select: {model.gravity_form: sheets}, field: position, error: 1e-3, "
    "least_order: -0.1, highest_order: 0.1}\n";

/// A folder with a scenario, in which mote compares.
class Place : public TemporaryFolder {
 public:
  explicit Place(const std::string& scenario = slab) { write(*this / "slab.yaml", scenario); }

  Outcome compare(const Names& more = {}, const std::string& out = "out") const {
    Names arguments{"compare", (*this / "slab.yaml").string(), "--out", (*this / out).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mote(arguments);
  }
  std::string file(const std::string& name) const { return read(*this / name); }
};

const Names both_forms{"--vary", "model.gravity_form=sheets,potential"};

Names names_in(const fs::path& folder) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

TEST(Compare, MakesARunOfEveryMember) {
  const Place place;
  const Outcome outcome = place.compare(
      {"--vary", "operator=mps,{family: sph, kernel: lucy}", "--vary", "particles.count=21,41"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.errors, IsEmpty());
  EXPECT_THAT(names_in(place / "out"),
              ElementsAre("compare.csv", "compare.md", "compare.yaml", "runs"));
  EXPECT_THAT(names_in(place / "out/runs"),
              ElementsAre("01-mps-21", "02-mps-41", "03-family_sph_kernel_lucy-21",
                          "04-family_sph_kernel_lucy-41"));
  const auto summary =
      nlohmann::json::parse(place.file("out/runs/03-family_sph_kernel_lucy-21/summary.json"));
  EXPECT_EQ(summary.at("operator"), "sph.lucy");
  EXPECT_EQ(summary.at("particles"), 21);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("[4/4] "), HasSubstr("report:  ")));
}

TEST(Compare, MakesTheSameRunAsMoteRun) {
  const Place place;
  EXPECT_EQ(place.compare({"--vary", "particles.count=21", "--quiet"}).exit_code, 0);
  EXPECT_EQ(mote({"run", (place / "slab.yaml").string(), "--set", "particles.count=21", "--out",
                  (place / "run").string()})
                .exit_code,
            0);
  EXPECT_EQ(place.file("out/runs/01-21/history.csv"), place.file("run/history.csv"));
}

TEST(Compare, HasARowForAMemberThatFails) {
  const Place place;
  const Outcome outcome = place.compare(both_forms);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, IsEmpty());
  EXPECT_THAT(outcome.output, HasSubstr("failed at t = 1.2"));
  EXPECT_THAT(outcome.output, HasSubstr("crossed"));
  const std::string table = place.file("out/compare.csv");
  EXPECT_THAT(table, StartsWith("model.gravity_form,time,particles,steps,position_l1,"));
  EXPECT_THAT(table, HasSubstr("\nsheets,2,41,200,"));
  EXPECT_THAT(table, HasSubstr("\npotential,1.2"));
  EXPECT_THAT(table, HasSubstr(",false,\"step 12"));
  EXPECT_THAT(place.file("out/compare.md"), HasSubstr("**failed at t = 1.2"));
  EXPECT_THAT(place.file("out/runs/02-potential.log"), HasSubstr("numerical failure"));
}

TEST(Compare, GoesOnFromTheFilesOwnSection) {
  const Place place(slab + crossing);
  const Outcome outcome = place.compare();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, Not(HasSubstr("FAILED")));
  EXPECT_THAT(place.file("out/compare.md"), HasSubstr("**Every expectation holds.**"));
}

TEST(Compare, EndsWith1IfAnExpectationDoesNotHold) {
  for (const std::string missed :
       {"{select: {model.gravity_form: potential}, fails_after: 1.5}",
        "{select: {model.gravity_form: sheets}, field: position, error: 1e-9}"}) {
    const Place place(slab +
                      "compare: {expect: [{select: {model.gravity_form: potential}, "
                      "fails_after: 0}, " +
                      missed + "]}\n");
    const Outcome outcome = place.compare(both_forms);
    EXPECT_EQ(outcome.exit_code, 1) << missed;
    EXPECT_THAT(outcome.output, HasSubstr("FAILED"));
  }
}

TEST(Compare, MayVaryTheFilesKeysAnew) {
  const Place place(slab + crossing);
  const Outcome outcome = place.compare(
      {"--vary", "model.gravity_form=sheets", "--set", "compare.expect=[]", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, IsEmpty());
  EXPECT_THAT(names_in(place / "out/runs"), ElementsAre("01-sheets-21", "02-sheets-41"));
}

TEST(Compare, ObservesOrders) {
  const Place place;
  EXPECT_EQ(place.compare({"--vary", "time.step=0.02,0.005,0.01"}).exit_code, 0);
  const CsvTable table(place.file("out/compare.csv"));
  EXPECT_EQ(table.rows.at(0).at("position_l2_order"), "");
  // Symplectic Euler is of first order.
  EXPECT_NEAR(std::stod(table.rows.at(1).at("position_l2_order")), 1, 0.1);
  EXPECT_NEAR(std::stod(table.rows.at(2).at("position_l2_order")), 1, 0.1);
}

TEST(Compare, CanBeMadeAgainFromItsFile) {
  const Place place(slab + crossing);
  EXPECT_EQ(place.compare({"--set", "operator.smoothing_length=1.1", "--quiet"}).exit_code, 0);
  EXPECT_EQ(mote({"compare", (place / "out/compare.yaml").string(), "--quiet", "--out",
                  (place / "again").string()})
                .exit_code,
            0);
  EXPECT_EQ(place.file("again/runs/04-potential-41/history.csv"),
            place.file("out/runs/04-potential-41/history.csv"));
}

/// Commas, quotes, spaces and what a shell would act on.
TEST(Compare, HandsValuesOnUnchanged) {
  const Place place;
  const Outcome outcome =
      place.compare({"--vary", "initial.density=\"max(1, x)\",\"x > 1 && $(x) < 2 ? 1 : 2\""});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("in the member initial.density = \"x > 1"));
  EXPECT_EQ(place
                .compare({"--vary", "initial.density=\"max(1, x)\",\"x > 1 ? 1 : 2\"", "--vary",
                          "units=SI,none"})
                .exit_code,
            0);
  EXPECT_THAT(place.file("out/compare.csv"),
              AllOf(HasSubstr("\n\"\"\"max(1, x)\"\"\",SI,"), HasSubstr(",none,")));
  EXPECT_THAT(place.file("out/runs/01-max_1_x-SI/run.yaml"), HasSubstr("density: \"max(1, x)\""));
  EXPECT_THAT(place.file("out/runs/03-x_1_1_2-SI/run.yaml"), HasSubstr("\"x > 1 ? 1 : 2\""));
}

TEST(Compare, DoesNotOverwriteUnlessAsked) {
  const Place place;
  EXPECT_EQ(place.compare(both_forms).exit_code, 1);
  write(place / "out/runs/01-sheets/mine.txt", "keep");
  write(place / "out/runs/notes.txt", "keep");
  write(place / "out/runs/9-notes.log", "keep");
  fs::create_directory(place / "out/runs/07-mine");
  write(place / "out/runs/07-mine/run.yaml", "name: not_of_mote\n");
  const Outcome refused = place.compare(both_forms);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("--overwrite replaces a former comparison"));
  EXPECT_EQ(place.compare({"--vary", "operator=mps", "--overwrite"}).exit_code, 0);
  EXPECT_THAT(names_in(place / "out/runs"),
              ElementsAre("01-mps", "01-sheets", "07-mine", "9-notes.log", "notes.txt"));
  EXPECT_THAT(names_in(place / "out/runs/01-sheets"), ElementsAre("mine.txt"));
  EXPECT_EQ(mote({"compare", (place / "slab.yaml").string(), "--vary", "operator=mps",
                  "--overwrite", "--out", (place / "out/runs/01-mps").string()})
                .exit_code,
            2)
      << "this is a run";
}

TEST(Compare, HasARowForAMemberThatLeavesNoResult) {
  const Place place;
  fs::create_directory(place / "out");
  write(place / "out/compare.yaml", "# The comparison as it was run.\n");
  fs::create_directories(place / "out/runs/01-mps");
  write(place / "out/runs/01-mps/mine.txt", "keeps the run out of this folder");
  const Outcome outcome = place.compare({"--vary", "operator=mps,sph.lucy", "--overwrite"});
  EXPECT_EQ(outcome.exit_code, 1);
  const std::string table = place.file("out/compare.csv");
  EXPECT_THAT(table, HasSubstr("\nmps,,,,"));
  EXPECT_THAT(table, HasSubstr(",false,\"ended with exit code 2: mote: "));
  EXPECT_THAT(table, HasSubstr(",true,,runs/02-sph.lucy\n"));
}

TEST(Compare, DrawsAPicture) {
  const Place place;
  const Outcome outcome =
      place.compare({"--vary", "particles.count=21,41", "--vary",
                     "model.gravity_form=sheets,potential", "--set", "output={every: 1}"});
  EXPECT_THAT(outcome.errors, IsEmpty());
  EXPECT_THAT(place.file("out/compare.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(place.file("out/compare.md"), HasSubstr("](compare.png)"));
}

TEST(Run, KeepsTheSectionCompareAndIgnoresIt) {
  const Place place(slab + crossing);
  const Outcome outcome =
      mote({"run", (place / "slab.yaml").string(), "--out", (place / "run").string(), "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(place.file("run/run.yaml"),
              HasSubstr("  vary:\n    model.gravity_form: [sheets, potential]\n"
                        "    particles.count: [21, 41]\n  expect:\n    - select:\n"
                        "        model.gravity_form: potential\n      fails_after: 1.2\n"));
}

}  // namespace
}  // namespace mote::test
