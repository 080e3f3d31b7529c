#include "mote/scenario/scenario.hpp"

#include <gmock/gmock.h>

#include "mote/scenario/suggestion.hpp"
#include "support/program.hpp"

namespace mote {
namespace {

using testing::HasSubstr;

const std::string text = R"(name: test
dimension: 1
constants: {L: 4, half: L/2}
domain: {lower: [0], upper: [2*half]}
particles: {count: 10*L + 1}
model: {type: pressureless_gas, gravity: 0.1}
initial: {density: "1 + x/L"}
operator: sph.gauss
time: {step: 0.1, end: 1}
)";

Document document(const std::string& contents) {
  const test::TemporaryFolder folder;
  return Document::from_file(test::write(folder / "test.yaml", contents).string());
}

Scenario scenario(const std::vector<std::string>& assignments = {}) {
  Document file = document(text);
  for (const auto& assignment : assignments) file.set(assignment);
  return read_scenario(file, standard_catalogue());
}

TEST(Scenario, EvaluatesNumbersThatAreExpressions) {
  const Scenario read = scenario();
  EXPECT_EQ(read.domain.upper[0], 4);
  EXPECT_EQ(read.particles.count, 41);
}

TEST(Scenario, FillsInDefaults) {
  const Scenario read = scenario();
  EXPECT_EQ(read.particles.layout, "regular");
  EXPECT_EQ(read.time.integrator, "velocity_verlet");
  EXPECT_EQ(read.domain.extension, 9);  // the Gaussian reaches 8.5 spacings
  EXPECT_EQ(read.output.every, 0.1);
  EXPECT_EQ(read.initial[1].second, "0");
}

TEST(Scenario, SetReplacesAndAdds) {
  EXPECT_EQ(scenario({"particles.count=7"}).particles.count, 7);
  EXPECT_EQ(scenario({"operator=mps"}).differential_operator.name(), "mps");
  EXPECT_EQ(scenario({"operator.kernel=lucy"}).differential_operator.name(), "sph.lucy");
  EXPECT_EQ(scenario({"domain.upper=[3]"}).domain.upper[0], 3);
  EXPECT_EQ(
      scenario({"operator={family: sph, kernel: truncated_gauss, cutoff: 2}"}).domain.extension, 2);
}

TEST(Scenario, ResolvedTextReadsBackToTheSameScenario) {
  const Catalogue catalogue = standard_catalogue();
  Scenario first = scenario({"operator.kernel=truncated_gauss", "operator.cutoff=1/3",
                             "check={against: gravitating_sheets, density: 0.1}"});
  const std::string resolved = resolved_yaml(first, catalogue);
  Scenario second = read_scenario(document(resolved), catalogue);
  EXPECT_EQ(resolved_yaml(second, catalogue), resolved);
  EXPECT_EQ(fingerprint(second, catalogue), fingerprint(first, catalogue));
  EXPECT_THAT(resolved, HasSubstr("cutoff: 0.3333333333333333"));
}

TEST(Scenario, FingerprintTellsScenariosApartButNotThreads) {
  const Catalogue catalogue = standard_catalogue();
  Scenario plain = scenario(), threaded = scenario({"threads=3"}), other = scenario({"time.end=2"});
  EXPECT_EQ(fingerprint(plain, catalogue), fingerprint(threaded, catalogue));
  EXPECT_NE(fingerprint(plain, catalogue), fingerprint(other, catalogue));
}

const std::string comparison =
    "compare={vary: {operator: [mps, {family: sph, kernel: lucy}], particles.count: [21, 41]}, "
    "expect: [{select: {particles.count: 21}, field: velocity, norm: max, least_order: 1.5}, "
    "{fails_after: 0, fails_before: 2}]}";

TEST(Comparison, ReadsBackFromTheResolvedText) {
  const Catalogue catalogue = standard_catalogue();
  Scenario first = scenario({comparison});
  EXPECT_EQ(first.compare.vary[0].values,
            (std::vector<std::string>{"mps", "{family: sph, kernel: lucy}"}));
  EXPECT_EQ(first.compare.expect[0].select[0].path, "particles.count");
  const std::string resolved = resolved_yaml(first, catalogue);
  Scenario second = read_scenario(document(resolved), catalogue);
  EXPECT_EQ(resolved_yaml(second, catalogue), resolved);
  EXPECT_EQ(second.compare.expect[0].norm, "max");
  EXPECT_EQ(second.compare.expect[1].fails_before, 2);
}

TEST(Comparison, IsNoPartOfTheRun) {
  const Catalogue catalogue = standard_catalogue();
  Scenario plain = scenario(), compared = scenario({comparison});
  EXPECT_EQ(fingerprint(plain, catalogue), fingerprint(compared, catalogue));
  EXPECT_EQ(resolved_yaml(plain, catalogue).find("compare"), std::string::npos);
}

TEST(FlowText, ReadsBackToTheSameValue) {
  for (const std::string text : {"mps", "{family: sph, kernel: gauss}", "[1, [2, a b], {c: [3]}]",
                                 "\"a, b\"", "\"\"", "~", "\"x: [\"", "1e-3", "\"{\"", "[]", "{}"})
    EXPECT_EQ(flow_text(Document::parsed(text, {})), text);
}

TEST(Suggestion, IsTheClosestWordIfCloseEnough) {
  EXPECT_EQ(suggestion("partcles", {"domain", "particles"}), " (did you mean 'particles'?)");
  EXPECT_EQ(suggestion("viscosity", {"domain", "particles"}), "");
  EXPECT_EQ(suggestion("x", {}), "");
}

}  // namespace
}  // namespace mote
