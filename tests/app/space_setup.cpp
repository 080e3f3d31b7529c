// From a scenario to the particles of a model in space.

#include "mote/app/space_setup.hpp"
#include "mote/catalogue/catalogue.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "mote/particles/failure.hpp"
#include "support/program.hpp"
#include "support/still_water.hpp"

namespace mote {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scenario scenario(const std::vector<std::string>& assignments = {}) {
  const test::TemporaryFolder folder;
  Document file = Document::from_file(test::write(folder / "test.yaml", test::tank).string());
  for (const auto& assignment : assignments) file.set(assignment);
  Catalogue catalogue = standard_catalogue();
  catalogue.add_model<test::StillWaterRecipe>();
  return read_scenario(file, catalogue);
}

std::string refusal(const std::vector<std::string>& assignments) {
  try {
    space_start(scenario(assignments));
  } catch (const InputError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

std::string regions(const std::string& list) { return "regions=[" + list + "]"; }

TEST(SpaceStart, HasTheBodiesOfTheScenario) {
  const SpaceStart start = space_start(scenario());
  std::vector<std::string> names;
  for (const Body& body : start.bodies) names.push_back(body.name);
  EXPECT_THAT(names, ElementsAre("fluid", "bed", "y_upper", "stone"));
  EXPECT_TRUE(start.bodies[1].slips);
  EXPECT_EQ(start.bodies[0].kind, BodyKind::fluid);
  EXPECT_EQ(start.bodies[3].kind, BodyKind::wall);
  EXPECT_THAT(start.periodic, ElementsAre(true, false, false));
  EXPECT_EQ(start.dimension, 2);
  EXPECT_THAT(start.upper, ElementsAre(2, 1, 0));
}

TEST(SpaceStart, FillsTheDomainAroundTheWallsWithFluid) {
  const SpaceStart start = space_start(scenario());
  const auto fluid = std::ranges::count(start.body, 0), stone = std::ranges::count(start.body, 3);
  EXPECT_EQ(fluid + stone, 200);
  EXPECT_NEAR(static_cast<double>(stone), 28.3, 5);  // pi (0.3/0.1)^2
  EXPECT_EQ(std::ranges::count(start.body, 1), 2 * 20);
  EXPECT_EQ(start.position.size(), 2 * start.body.size());
  EXPECT_EQ(start.wall_places.size(), start.body.size() - static_cast<std::size_t>(fluid));
}

TEST(SpaceStart, MovesWallsByTheirExpressions) {
  const SpaceStart start = space_start(scenario());
  EXPECT_FALSE(start.bodies[1].velocity);
  EXPECT_THAT(start.bodies[2].velocity(2), ElementsAre(0.5 * std::sin(2.0), 0, 0));
  const SpaceStart late = space_start(scenario(
      {"domain.walls=[{side: y_lower, name: bed}, {side: y_upper, velocity: [sqrt(1 - t), 0]}]"}));
  EXPECT_THROW(late.bodies[2].velocity(2), NumericalFailure);
}

TEST(SpaceStart, EvaluatesInitialFieldsAndFormulas) {
  const SpaceStart start = space_start(scenario());
  EXPECT_DOUBLE_EQ(start.initial("pressure", {0, 0.25, 0}), 0.75);
  const PlaceFunction formula = start.compile("U*x + y + 10*t");
  EXPECT_DOUBLE_EQ(formula({2, 3, 0}, 1), 14);
}

TEST(SpaceStart, SaysWhereAnInitialFieldHasNoValue) {
  const SpaceStart start = space_start(scenario({"initial.pressure=1/x"}));
  try {
    start.initial("pressure", {0, 0.5, 0});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "initial.pressure");
    EXPECT_THAT(error.what(), HasSubstr("'pressure' is inf at (0, 0.5)"));
  }
}

TEST(SpaceStart, NamesTheKeyOfARegionThatCannotBe) {
  EXPECT_THAT(refusal({regions("{name: a, type: fluid, shapes: [{type: ball, centre: [1, 1], "
                               "radius: 0.5}]}")}),
              HasSubstr("regions.0: the fluid 'a' goes beyond the domain"));
  EXPECT_THAT(
      refusal({regions("{name: a, type: fluid, shapes: [{type: polygon, x: [0, 1, 1, 0], y: "
                       "[0, 1, 0, 1]}]}")}),
      HasSubstr("regions.0.shapes.0: the polygon crosses itself"));
  EXPECT_THAT(refusal({regions("{name: all, type: wall, shapes: [{type: expression, inside: \"2 - "
                               "y\"}]}")}),
              HasSubstr("regions: the fluid 'fluid' has no particle in it"));
}

TEST(SpaceStart, MovesNoFluidOnALattice) {
  const SpaceStart start = space_start(scenario({"particles={spacing: 0.1}"}));
  EXPECT_DOUBLE_EQ(start.position[0], 0.05);
  EXPECT_NE(space_start(scenario()).position[0], start.position[0]);
}

TEST(SpaceSetup, TakesOperatorAndSearch) {
  Scenario read = scenario();
  const SpaceSetup setup = space_setup(read, standard_catalogue());
  EXPECT_NE(dynamic_cast<DifferentialOperator<2>*>(setup.differential_operator.get()), nullptr);
  EXPECT_EQ(setup.search, "kd_tree");
  EXPECT_EQ(*setup.skin, 0.1);
  Scenario plain = scenario({"neighbours={}"});
  EXPECT_EQ(space_setup(plain, standard_catalogue()).search, "");
}

TEST(MemoryInSpace, GrowsWithTheNumberOfParticles) {
  const double coarse = memory_in_space(scenario());
  const double fine = memory_in_space(scenario({"particles.spacing=L/400"}));
  EXPECT_GT(fine, 200 * coarse);
  EXPECT_LT(fine, 400 * coarse);
}

}  // namespace
}  // namespace mote
