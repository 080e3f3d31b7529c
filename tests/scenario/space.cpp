// Scenarios of models in space: what they say, its defaults, and what does not go together.

#include <gmock/gmock.h>

#include "mote/catalogue/catalogue.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/scenario.hpp"
#include "mote/scenario/schema.hpp"
#include "support/program.hpp"
#include "support/still_water.hpp"

namespace mote {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

Catalogue catalogue() {
  Catalogue catalogue = standard_catalogue();
  catalogue.add_model<test::StillWaterRecipe>();
  return catalogue;
}

Document document(const std::vector<std::string>& assignments, const std::string& text) {
  const test::TemporaryFolder folder;
  Document document = Document::from_file(test::write(folder / "test.yaml", text).string());
  for (const auto& assignment : assignments) document.set(assignment);
  return document;
}

Scenario scenario(const std::vector<std::string>& assignments = {},
                  const std::string& text = test::tank) {
  return read_scenario(document(assignments, text), catalogue());
}

std::string refusal(const std::vector<std::string>& assignments) {
  try {
    scenario(assignments);
  } catch (const LocatedError& error) {
    return error.what();
  }
  return "";
}

TEST(SpaceScenario, SaysWhatIsInTheDomain) {
  const Scenario read = scenario();
  EXPECT_THAT(read.domain.periodic, ElementsAre("x"));
  EXPECT_EQ(read.domain.walls[0].name, "bed");
  EXPECT_TRUE(read.domain.walls[0].slips);
  EXPECT_THAT(read.domain.walls[1].velocity, ElementsAre("U*sin(t)", "0"));
  EXPECT_EQ(*read.particles.spacing, 0.1);
  EXPECT_EQ(read.regions[0].shapes[0].radius, 0.3);
  EXPECT_EQ(read.neighbours.search, "kd_tree");
  EXPECT_EQ(*read.neighbours.skin, 0.1);
}

TEST(SpaceScenario, FillsInDefaults) {
  const Scenario read = scenario({"neighbours={}"});
  EXPECT_EQ(read.domain.walls[1].name, "y_upper");
  EXPECT_FALSE(read.domain.walls[1].slips);
  EXPECT_FALSE(read.domain.walls[1].travels);
  EXPECT_TRUE(read.regions[0].travels);
  EXPECT_EQ(*read.particles.jitter, 0.2);
  EXPECT_EQ(*read.time.courant, 0.25);
  EXPECT_FALSE(read.time.step);
  EXPECT_EQ(read.output.history, 0);
  EXPECT_EQ(read.neighbours.search, "automatic");
  EXPECT_FALSE(read.neighbours.skin);
  EXPECT_FALSE(read.domain.boundary);
  EXPECT_EQ(scenario({"particles={spacing: 0.1}"}).particles.layout, "lattice");
  EXPECT_EQ(scenario({"initial={}"}).initial[0].second, "0");
}

TEST(SpaceScenario, ResolvedTextReadsBackToTheSameScenario) {
  const std::string shapes =
      "[{type: box, lower: [0.1, 0.1], upper: [0.2, 0.2]}, {type: polygon, x: [0, 1, 0], y: [0, 0, "
      "1]}, {type: expression, inside: \"U - r\"}]";
  Scenario first = scenario({"time.step=0.01", "regions=[{name: a, type: fluid, shapes: " + shapes +
                                                   ", except: " + shapes +
                                                   "}, {name: b, type: wall, slip: free, velocity: "
                                                   "[0, t], travels: false, shapes: " +
                                                   shapes + "}]"});
  const std::string resolved = resolved_yaml(first, catalogue());
  Scenario second = scenario({}, resolved);
  EXPECT_EQ(resolved_yaml(second, catalogue()), resolved);
  EXPECT_EQ(fingerprint(second, catalogue()), fingerprint(first, catalogue()));
  EXPECT_THAT(resolved, HasSubstr("inside: \"U - r\""));
  for (const char* stranger : {"boundary", "extension", "count:"})
    EXPECT_EQ(resolved.find(stranger), std::string::npos);
}

TEST(SpaceScenario, HasAPrismInThreeDimensions) {
  const Scenario read = scenario(
      {"dimension=3",
       "domain={lower: [0, 0, 0], upper: [1, 1, 1], periodic: [x, y], walls: [{side: "
       "z_upper}]}",
       "regions=[{name: a, type: fluid, shapes: [{type: polygon, x: [0, 1, 0], y: [0, 0, 1], "
       "z_lower: 0.25, z_upper: 0.5}]}]"});
  EXPECT_EQ(*read.regions[0].shapes[0].z_upper, 0.5);
  EXPECT_EQ(read.domain.walls[0].name, "z_upper");
}

TEST(SpaceScenario, SchemaHasTheFieldsOfAllModels) {
  const std::string schema = scenario_schema(catalogue());
  for (const char* field : {"\"density\"", "\"pressure\"", "\"z_lower\"", "\"courant\""})
    EXPECT_THAT(schema, HasSubstr(field));
}

TEST(SpaceScenario, RefusesKeysOfModelsOnALine) {
  for (const std::string key : {"domain.boundary=held", "domain.extension=3", "particles.count=9"})
    EXPECT_THAT(refusal({key}), HasSubstr(key + ": '")) << key;
  EXPECT_THAT(refusal({"particles.count=9"}),
              EndsWith("'count' belongs to models on a line, and the model still_water lives in "
                       "space"));
  EXPECT_THAT(refusal({"particles.layout=geometric"}), HasSubstr("'geometric' belongs to models"));
  EXPECT_THAT(refusal({"neighbours.search=line"}), HasSubstr("'line' belongs to models on a line"));
  EXPECT_THAT(refusal({"dimension=1"}), HasSubstr("dimension must be 2 or 3, and is 1"));
}

TEST(SpaceScenario, RefusesParticlesThatAreNotDescribed) {
  EXPECT_THAT(refusal({"particles={seed: 1}"}), HasSubstr("'particles' lacks the key 'spacing'"));
  EXPECT_THAT(refusal({"particles={spacing: 0.1, jitter: 0.1}"}),
              HasSubstr("'jitter' has a meaning for the layout 'jittered' alone"));
  EXPECT_THAT(refusal({"particles.jitter=0.5"}), HasSubstr("'jitter' must be from 0 to 0.45"));
}

TEST(SpaceScenario, RefusesSidesThatCannotBe) {
  EXPECT_THAT(refusal({"domain.periodic=[y]"}),
              HasSubstr("the side y_lower cannot be a wall: the axis y is periodic"));
  EXPECT_THAT(refusal({"domain.periodic=[x, x]"}), HasSubstr("the axis x is given twice"));
  EXPECT_THAT(refusal({"domain.periodic=[z]"}), HasSubstr("there is no axis z in 2 dimensions"));
  EXPECT_THAT(refusal({"domain.walls=[{side: y_upper}, {side: y_upper, name: b}]"}),
              HasSubstr("the side y_upper is a wall twice"));
  EXPECT_THAT(refusal({"domain.walls=[{side: z_upper}]"}),
              HasSubstr("there is no side z_upper in 2 dimensions"));
  EXPECT_THAT(refusal({"domain.walls=[{name: bed}]"}), HasSubstr("lacks the key 'side'"));
  EXPECT_THAT(refusal({"domain.walls=[{side: y_upper, name: stone}]"}),
              HasSubstr("there are two bodies with the name 'stone'"));
}

TEST(SpaceScenario, RefusesVelocitiesThatDependOnThePlace) {
  const auto lid = [](const std::string& velocity) {
    return refusal({"domain.walls=[{side: y_upper, velocity: " + velocity + "}]"});
  };
  EXPECT_THAT(lid("[t, y]"), HasSubstr("depends on t alone, and this names y"));
  EXPECT_THAT(lid("[t]"), HasSubstr("'velocity' needs 2 numbers, one a dimension, and has 1"));
  EXPECT_THAT(lid("[1/t, 0]"), HasSubstr("not a finite number at t = 0"));
}

TEST(SpaceScenario, RefusesShapesThatCannotBe) {
  const auto shape = [](const std::string& text) {
    return refusal({"regions=[{name: a, type: fluid, shapes: [{" + text + "}]}]"});
  };
  EXPECT_THAT(shape("type: box, lower: [0], upper: [1, 1]"),
              HasSubstr("'lower' needs 2 numbers, one a dimension, and has 1"));
  EXPECT_THAT(shape("type: box, lower: [0, 1], upper: [1, 1]"),
              HasSubstr("the upper end 1 must lie above the lower 1"));
  EXPECT_THAT(shape("type: ball, centre: [1, 1, 1], radius: 1"), HasSubstr("'centre' needs 2"));
  EXPECT_THAT(shape("type: ball, centre: [1, 1], radius: 0"), HasSubstr("must be greater than 0"));
  EXPECT_THAT(shape("type: polygon, x: [0, 1, 0], y: [0, 0, 1], z_upper: 1"),
              HasSubstr("a polygon has no ends along z in 2 dimensions"));
  EXPECT_THAT(shape("type: expression, inside: \"t - x\""), HasSubstr("does not depend on t"));
  EXPECT_THAT(shape("type: expression, inside: \"1 - z\""), HasSubstr("there is no axis z"));
  EXPECT_THAT(refusal({"regions=[{name: a, type: fluid, shapes: []}]"}),
              HasSubstr("'shapes' must not be empty"));
  EXPECT_THAT(refusal({"regions=[{name: a, type: fluid, slip: free, shapes: [{type: ball, centre: "
                       "[1, 1], radius: 1}]}]"}),
              HasSubstr("unknown key 'slip' in section 'regions'"));
}

TEST(SpaceScenario, RefusesCourantNumbersOutOfRange) {
  EXPECT_THAT(refusal({"time.courant=0"}),
              HasSubstr("'courant' must be greater than 0 and at most 1, and is 0"));
}

}  // namespace
}  // namespace mote
