// Which members a comparison has, and what they are made from.

#include "mote/compare/comparison.hpp"

#include <gmock/gmock.h>

#include "compare/members.hpp"
#include "mote/compare/variations.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string scenario =
    "name: base\nparticles: {count: 41}\noperator: sph.gauss\ncompare:\n  vary:\n"
    "    operator: [mps, {family: sph, kernel: lucy}]\n    particles.count: [21, 41]\n";

Document document(const std::string& text = scenario) {
  const TemporaryFolder folder;
  return Document::from_file(write(folder / "base.yaml", text).string());
}

TEST(Members, AreTheProductAndTheLastKeyIsTheFastest) {
  const Comparison made = comparison({{"operator", {"a", "b"}}, {"time.step", {"1", "2", "3"}}});
  std::vector<std::string> labels;
  for (const Member& member : made.members) labels.push_back(made.label(member));
  EXPECT_THAT(labels, ElementsAre("operator = a, time.step = 1", "operator = a, time.step = 2",
                                  "operator = a, time.step = 3", "operator = b, time.step = 1",
                                  "operator = b, time.step = 2", "operator = b, time.step = 3"));
}

TEST(Members, HaveFoldersThatFilesCanHave) {
  const Comparison made =
      comparison({{"operator", {"{family: sph, kernel: lucy}", "../x"}}, {"a", {"\"y z\"", "-1"}}});
  std::vector<std::string> folders;
  for (const Member& member : made.members) folders.push_back(member.folder);
  EXPECT_THAT(folders,
              ElementsAre("runs/01-family_sph_kernel_lucy-y_z", "runs/02-family_sph_kernel_lucy--1",
                          "runs/03-.._x-y_z", "runs/04-.._x--1"));
}

TEST(Members, AreNotTooMany) {
  EXPECT_EQ(comparison({{"a", std::vector<std::string>(1000, "1")}}).members.size(), 1000u);
  EXPECT_THROW(comparison({{"a", std::vector<std::string>(1001, "1")}}), InputError);
}

TEST(Refinement, IsTheNumberOfParticlesRatherThanTheStep) {
  EXPECT_EQ(comparison({{"time.step", {"1"}}, {"particles.count", {"2"}}}).refinement, 1u);
  EXPECT_EQ(comparison({{"operator", {"a"}}, {"time.step", {"1"}}}).refinement, 1u);
  EXPECT_EQ(comparison({{"operator", {"a"}}}).refinement, std::nullopt);
}

TEST(Refinement, GoesByTheSpacingInEveryDimension) {
  Scenario scenario;
  scenario.particles.count = 64;
  scenario.particles.spacing = 0.25;
  scenario.time.step = 0.5;
  for (const auto& [dimension, spacing] : {std::pair{1, 1.0 / 64}, {2, 1.0 / 8}, {3, 1.0 / 4}}) {
    scenario.dimension = dimension;
    EXPECT_DOUBLE_EQ(spacing_along("particles.count", scenario), spacing);
    EXPECT_EQ(spacing_along("particles.spacing", scenario), 0.25);
    EXPECT_EQ(spacing_along("time.step", scenario), 0.5);
  }
}

TEST(Members, AreMadeFromTheBaseAndTheirValues) {
  const Document base = document();
  const Comparison made = comparison(
      {{"operator", {"mps", "{family: sph, kernel: lucy}"}}, {"particles.count", {"21", "41"}}});
  const Document member = document_of(base, made, made.members[2]);
  EXPECT_EQ(member.find({"operator", "kernel"})->word, "lucy");
  EXPECT_EQ(member.find({"particles", "count"})->word, "21");
  EXPECT_THAT(member.locate("particles.count"), testing::EndsWith("base.yaml:7:23"));
  EXPECT_THAT(assignments_of(made, made.members[2]),
              ElementsAre("operator={family: sph, kernel: lucy}", "particles.count=21"));
}

/// In the other order the section would replace what is in it.
TEST(Members, TakeSectionsBeforeTheKeysInThem) {
  const Comparison made = comparison({{"operator.smoothing_length", {"2"}}, {"operator", {"mps"}}});
  EXPECT_THAT(assignments_of(made, made.members[0]),
              ElementsAre("operator=mps", "operator.smoothing_length=2"));
}

TEST(Variations, ReplaceTheFilesValuesOfAKeyAndAddOthers) {
  Document varied = document();
  vary(varied, {"particles.count=81", "time.step={a: 1, b: [2, 3]},4"}, {});
  EXPECT_EQ(flow_text(*varied.find({"compare", "vary"})),
            "{operator: [mps, {family: sph, kernel: lucy}], particles.count: [81], "
            "time.step: [{a: 1, b: [2, 3]}, 4]}");
}

TEST(Variations, LeaveNothingOfTheCommandLineWithoutEffect) {
  Document varied = document();
  for (const std::string set : {"operator=mps", "operator.kernel=gauss", "particles.count=3"})
    EXPECT_THROW(vary(varied, {}, {set}), LocatedError) << set;
  EXPECT_NO_THROW(vary(varied, {}, {"particles.seed=3", "name=a"}));
}

TEST(ComparisonFile, IsTheFileAsGivenWithAllThatTheCommandLineSaid) {
  Document base = document();
  base.set("operator.smoothing_length=2");
  vary(base, {"particles.count=5"}, {});
  const std::string text =
      comparison_yaml(base, "operator: {family: sph, kernel: gauss, smoothing_length: 2}");
  EXPECT_THAT(text, StartsWith("name: base\nparticles:\n  count: 41\noperator:\n  family: sph\n"
                               "  kernel: gauss\n  smoothing_length: 2\ncompare:\n"));
  EXPECT_THAT(text, HasSubstr("particles.count: [5]\nversion: "));
  EXPECT_EQ(document(text).find({"compare", "vary", "operator"})->list.size(), 2u);
}

}  // namespace
}  // namespace mote::test
