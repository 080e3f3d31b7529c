// Particles in domains: how many, where, whose, and what is refused.

#include "mote/geometry/filling.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mote/geometry/ball.hpp"
#include "mote/geometry/box.hpp"
#include "mote/geometry/formula_shape.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using testing::HasSubstr;

constexpr double endless = Extent::endless;

SharedShape box(const Triple& lower, const Triple& upper) {
  return std::make_shared<Box>(Extent{lower, upper});
}

SharedShape rectangle(double x_lower, double y_lower, double x_upper, double y_upper) {
  return box({x_lower, y_lower, -endless}, {x_upper, y_upper, endless});
}

Region fluid(SharedShape whole, const std::string& name = "water") {
  return {{.name = name}, std::move(whole), nullptr, "regions.0"};
}

Region solid(SharedShape whole, SharedShape without = nullptr) {
  return {
      {.name = "rock", .kind = BodyKind::wall}, std::move(whole), std::move(without), "regions.1"};
}

SideWall side(int axis, bool upper) {
  const std::string name = std::string(axis_names[axis]) + (upper ? "_upper" : "_lower");
  return {{.name = name, .kind = BodyKind::wall}, {axis, upper}};
}

/// Fluid in a rectangle of 8 by 6 spacings; the operator reaches 2.5.
SpacePlan plane() {
  SpacePlan plan;
  plan.upper = {4, 3, 0};
  plan.spacing = 0.5;
  plan.reach = 2.5;
  plan.regions = {fluid(rectangle(0, 0, 4, 3))};
  return plan;
}

SpacePlan with_walls(std::vector<SideWall> walls) {
  SpacePlan plan = plane();
  plan.walls = std::move(walls);
  return plan;
}

SpacePlan with_region(Region region) {
  SpacePlan plan = plane();
  plan.regions.push_back(std::move(region));
  return plan;
}

/// Number of particles of every body, by name.
std::map<std::string, int> counts(const Filling& filling) {
  std::map<std::string, int> counts;
  for (const std::int32_t body : filling.body) ++counts[filling.bodies[body].name];
  return counts;
}

/// The wall particle, with its place in the wall, that is nearest to this place.
struct WallParticle {
  std::string wall;
  Triple place;
  WallPlace seen;
};

WallParticle wall_at(const Filling& filling, int dimension, const Triple& place) {
  const std::size_t count = filling.body.size(), fluids = count - filling.wall_places.size();
  WallParticle nearest;
  double least = endless;
  for (std::size_t i = fluids; i < count; ++i) {
    Triple at{};
    for (int d = 0; d < dimension; ++d) at[d] = filling.position[i * dimension + d];
    const double distance = std::hypot(at[0] - place[0], at[1] - place[1], at[2] - place[2]);
    if (distance >= least) continue;
    least = distance;
    nearest = {filling.bodies[filling.body[i]].name, at, filling.wall_places[i - fluids]};
  }
  return nearest;
}

std::string refusal(const SpacePlan& plan) {
  try {
    filled(plan);
  } catch (const InputError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

TEST(Filling, PutsAParticleInTheMiddleOfEveryCellXFastest) {
  const Filling filling = filled(plane());
  EXPECT_EQ(filling.body.size(), 48u);
  EXPECT_TRUE(filling.wall_places.empty());
  EXPECT_THAT(std::vector(filling.position.begin(), filling.position.begin() + 4),
              testing::ElementsAre(0.25, 0.25, 0.75, 0.25));
  EXPECT_THAT(std::vector(filling.position.end() - 2, filling.position.end()),
              testing::ElementsAre(3.75, 2.75));
}

TEST(Filling, HasAsManyWholeCellsAsFitBelowAnOpenSide) {
  SpacePlan plan = plane();
  plan.upper[1] = 3.2;
  plan.regions = {fluid(rectangle(0, 0, 4, 3.2))};
  EXPECT_EQ(filled(plan).body.size(), 48u);
  plan.upper[1] = 3.3;
  plan.regions = {fluid(rectangle(0, 0, 4, 3.3))};
  EXPECT_EQ(filled(plan).body.size(), 56u);
}

TEST(Filling, MovesFluidAloneByUpToTheJitter) {
  SpacePlan plan = with_walls({side(1, false)});
  const Filling still = filled(plan);
  plan.jitter = 0.2;
  const Filling moved = filled(plan);
  double furthest = 0;
  for (std::size_t k = 0; k < still.position.size(); ++k) {
    const double move = std::abs(moved.position[k] - still.position[k]);
    if (k >= 96) {
      EXPECT_EQ(move, 0);
    }
    furthest = std::max(furthest, move);
  }
  EXPECT_LE(furthest, 0.1);
  EXPECT_GT(furthest, 0.09);
  plan.seed = 1;
  EXPECT_NE(filled(plan).position, moved.position);
}

TEST(Filling, PutsLayersBeyondAWallAndPastItsEnds) {
  EXPECT_THAT(counts(filled(with_walls({side(1, false)}))),
              testing::UnorderedElementsAre(testing::Pair("water", 48),
                                            testing::Pair("y_lower", 3 * (8 + 2 * 3))));
}

TEST(Filling, GivesACornerToTheWallThatIsFirst) {
  const std::vector<SideWall> walls{side(1, false), side(0, false), side(0, true)};
  EXPECT_THAT(counts(filled(with_walls(walls))),
              testing::UnorderedElementsAre(
                  testing::Pair("water", 48), testing::Pair("y_lower", 3 * 14),
                  testing::Pair("x_lower", 3 * 9), testing::Pair("x_upper", 3 * 9)));
  EXPECT_EQ(counts(filled(with_walls({walls[1], walls[0]})))["y_lower"], 3 * 11);
}

TEST(Filling, EndsAWallAtPeriodicSides) {
  SpacePlan plan = with_walls({side(1, false), side(1, true)});
  plan.periodic[0] = true;
  EXPECT_EQ(counts(filled(plan))["y_lower"], 3 * 8);
  EXPECT_EQ(counts(filled(plan))["y_upper"], 3 * 8);
}

TEST(Filling, SeesSideWallsFromTheNearestPointOfTheDomain) {
  const Filling filling = filled(with_walls({side(1, false), side(0, false), side(0, true)}));
  const WallParticle bed = wall_at(filling, 2, {2.25, -0.75, 0});
  EXPECT_EQ(bed.wall, "y_lower");
  EXPECT_DOUBLE_EQ(bed.seen.depth, 0.75);
  EXPECT_THAT(bed.seen.normal, testing::ElementsAre(0, 1, 0));
  const WallParticle corner = wall_at(filling, 2, {4.75, -0.75, 0});
  EXPECT_DOUBLE_EQ(corner.seen.depth, std::hypot(0.75, 0.75));
  EXPECT_DOUBLE_EQ(corner.seen.normal[0], -std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(corner.seen.normal[1], std::sqrt(0.5));
}

TEST(Filling, SeesTheEndOfAWallAtAnOpenSideStraightOn) {
  const Filling filling = filled(with_walls({side(1, false)}));
  EXPECT_THAT(wall_at(filling, 2, {4.75, -0.75, 0}).seen.normal, testing::ElementsAre(0, 1, 0));
}

TEST(Filling, SeesWallRegionsFromTheirSurface) {
  SpacePlan plan = with_region(solid(rectangle(0, -3, 4, 0)));
  const WallParticle particle = wall_at(filled(plan), 2, {2.25, -0.75, 0});
  EXPECT_EQ(particle.wall, "rock");
  EXPECT_DOUBLE_EQ(particle.seen.depth, 0.75);
  EXPECT_THAT(particle.seen.normal, testing::ElementsAre(0, 1, 0));
}

TEST(Filling, SeesAWallWithAHollowFromTheHollow) {
  SpacePlan plan = with_region(solid(rectangle(-2, -2, 6, 5), rectangle(0, 0, 4, 3)));
  const Filling filling = filled(plan);
  EXPECT_EQ(counts(filling)["rock"], 16 * 14 - 48);
  const WallParticle right = wall_at(filling, 2, {4.75, 1.25, 0});
  EXPECT_DOUBLE_EQ(right.seen.depth, 0.75);
  EXPECT_NEAR(right.seen.normal[0], -1, 1e-12);
}

TEST(Filling, PrefersARegionToTheWallOnASide) {
  SpacePlan plan = with_region(solid(rectangle(1, -3, 3.5, 0)));
  plan.walls = {side(1, false)};
  const auto found = counts(filled(plan));
  EXPECT_EQ(found.at("rock"), 5 * 6);
  EXPECT_EQ(found.at("y_lower"), 3 * 14 - 5 * 3);
}

TEST(Filling, EndsWallsOfFormulasWithTheLayersTheyNeed) {
  const auto below = std::make_shared<FormulaShape>([](const Triple& p) { return -p[1]; }, 2, 1e-4);
  EXPECT_EQ(counts(filled(with_region(solid(below))))["rock"], 3 * 14);
  SpacePlan plan = with_region(solid(below));
  plan.periodic[0] = true;
  EXPECT_EQ(counts(filled(plan))["rock"], 3 * 8);
}

TEST(Filling, OrdersFluidsBeforeWalls) {
  SpacePlan plan = plane();
  plan.regions = {solid(rectangle(0, -2.5, 4, 0)), fluid(rectangle(0, 0, 2, 3), "left"),
                  fluid(rectangle(2, 0, 4, 3), "right")};
  plan.walls = {side(1, true)};
  const Filling filling = filled(plan);
  std::vector<std::string> names;
  for (const Body& body : filling.bodies) names.push_back(body.name);
  EXPECT_THAT(names, testing::ElementsAre("left", "right", "y_upper", "rock"));
  EXPECT_TRUE(std::ranges::is_sorted(filling.body));
  EXPECT_EQ(filling.wall_places.size(), filling.body.size() - 48);
}

/// A tank of 6 x 4 x 4 spacings, with a floor and two walls along x.
SpacePlan tank() {
  SpacePlan plan;
  plan.dimension = 3;
  plan.upper = {6, 4, 4};
  plan.reach = 2;
  plan.regions = {fluid(box({0, 0, 0}, {6, 4, 4}))};
  plan.walls = {side(2, false), side(1, false), side(1, true)};
  plan.periodic[0] = true;
  return plan;
}

TEST(Filling, WorksInThreeDimensions) {
  const Filling filling = filled(tank());
  EXPECT_THAT(counts(filling), testing::UnorderedElementsAre(testing::Pair("water", 96),
                                                             testing::Pair("z_lower", 6 * 8 * 2),
                                                             testing::Pair("y_lower", 6 * 2 * 6),
                                                             testing::Pair("y_upper", 6 * 2 * 6)));
  const WallParticle edge = wall_at(filling, 3, {2.5, -0.5, -0.5});
  EXPECT_DOUBLE_EQ(edge.seen.depth, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(edge.seen.normal[2], std::sqrt(0.5));
}

TEST(Filling, LeavesRoomForABallInAFluid) {
  SpacePlan plan = tank();
  const auto ball = std::make_shared<Ball>(Triple{3, 2, 2}, 2.4);
  plan.regions.front().without = ball;
  plan.regions.push_back(solid(ball));
  const auto found = counts(filled(plan));
  EXPECT_EQ(found.at("water") + found.at("rock"), 96);
  EXPECT_EQ(found.at("rock"), 56);  // of the 64 cells around the centre all but the 8 corners
}

TEST(Filling, NeverHasMoreParticlesThanTheEstimate) {
  for (const SpacePlan& plan : {plane(), with_walls({side(1, false), side(0, true)}), tank(),
                                with_region(solid(rectangle(-2, -2, 6, 5), rectangle(0, 0, 4, 3)))})
    EXPECT_LE(static_cast<double>(filled(plan).body.size()), most_particles(plan));
}

TEST(Filling, EstimatesWithoutFillingWhatNoMachineCouldHold) {
  SpacePlan plan = tank();
  plan.spacing = 1e-6;
  EXPECT_NEAR(most_particles(plan), 96e18, 1e18);
}

TEST(FillingRefusal, OfFluidBeyondTheDomain) {
  SpacePlan plan = plane();
  plan.regions = {fluid(rectangle(0, 0, 5, 3))};
  EXPECT_EQ(refusal(plan), "regions.0: the fluid 'water' goes beyond the domain, to (4.25, 0.25)");
}

TEST(FillingRefusal, OfRegionsOnTopOfEachOther) {
  EXPECT_EQ(refusal(with_region(solid(rectangle(3, 1, 4, 2)))),
            "regions.1: the fluid 'water' and the wall 'rock' lie on top of each other at (3.25, "
            "1.25)");
  EXPECT_THAT(refusal(with_region(fluid(rectangle(3, 1, 4, 2), "oil"))),
              HasSubstr("the fluid 'water' and the fluid 'oil' lie on top of each other"));
}

TEST(FillingRefusal, OfAWallThatTheOperatorSeesThrough) {
  EXPECT_EQ(refusal(with_region(solid(rectangle(0, -1, 4, 0)))),
            "regions.1: the wall 'rock' is 1 spacings deep, and the operator reaches 2.5: the "
            "fluid would see through it");
  EXPECT_EQ(refusal(with_region(solid(rectangle(-1.5, -1.5, 5.5, 4.5), rectangle(0, 0, 4, 3)))),
            "");
}

TEST(FillingRefusal, OfARegionWithoutParticles) {
  EXPECT_EQ(refusal(with_region(solid(rectangle(-1, -1, -0.9, -0.9)))),
            "regions.1: the wall 'rock' has no particle in it");
}

TEST(FillingRefusal, OfSidesThatAreNotWholeSpacingsApart) {
  SpacePlan plan = plane();
  plan.upper[0] = 4.1;
  EXPECT_EQ(refusal(plan), "");
  plan.periodic[0] = true;
  EXPECT_EQ(refusal(plan),
            "particles.spacing: between the sides of the domain there are 8.2 spacings along x, "
            "which must be a whole number; the nearest spacing that fits is 0.5125");
  plan.periodic[0] = false;
  plan.walls = {side(0, false)};
  EXPECT_EQ(refusal(plan), "");
  plan.walls = {side(0, true)};
  EXPECT_THAT(refusal(plan), HasSubstr("8.2 spacings along x"));
}

TEST(FillingRefusal, OfAPeriodicDomainThatTheOperatorReachesAround) {
  SpacePlan plan = plane();
  plan.periodic[1] = true;
  EXPECT_EQ(refusal(plan), "");
  plan.reach = 3.1;
  EXPECT_THAT(refusal(plan), HasSubstr("domain.periodic: the domain is 6 spacings long along y"));
}

TEST(FillingRefusal, OfASpacingLongerThanTheDomain) {
  SpacePlan plan = plane();
  plan.spacing = 7;
  EXPECT_THAT(refusal(plan), HasSubstr("the spacing 7 is longer than the domain along y"));
}

TEST(FillingRefusal, OfAWallWhoseSurfaceHasNoDistance) {
  const auto step =
      std::make_shared<FormulaShape>([](const Triple& p) { return p[1] < 0 ? 1 : -1; }, 2, 1e-4);
  EXPECT_THAT(refusal(with_region(solid(step))), HasSubstr("has no distance from (-1.25, -1.25)"));
}

}  // namespace
}  // namespace mote
