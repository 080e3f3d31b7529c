#include "mote/particles/extension.hpp"

#include <gtest/gtest.h>

namespace mote::test {
namespace {

using Numbers = std::vector<double>;

struct LineExtensionOfThree : testing::Test {
  Numbers position{1, 2.5, 5}, mass{10, 20, 30}, density{0.1, 0.2, 0.3}, length{1, 2, 3};
  LineOfParticles line{position, mass, density, length};
  Points<1> points;
};

TEST_F(LineExtensionOfThree, ContinuesBothEndsWithTheEndCells) {
  LineExtension(2).extend(line, points);
  EXPECT_EQ(points.receivers, 3);
  EXPECT_EQ(points.size(), 7);
  EXPECT_EQ(points.position, (Numbers{1, 2.5, 5, 0, -1, 8, 11}));
  EXPECT_EQ(points.mass, (Numbers{10, 20, 30, 10, 10, 30, 30}));
  EXPECT_EQ(points.density, (Numbers{0.1, 0.2, 0.3, 0.1, 0.1, 0.3, 0.3}));
  EXPECT_EQ(points.length, (Numbers{1, 2, 3, 1, 1, 3, 3}));
}

TEST_F(LineExtensionOfThree, OfNoCellsIsTheLineItself) {
  LineExtension(0).extend(line, points);
  EXPECT_EQ(points.receivers, 3);
  EXPECT_EQ(points.position, position);
  EXPECT_EQ(points.length, length);
}

TEST_F(LineExtensionOfThree, ReplacesWhatPointsHeldBefore) {
  LineExtension(4).extend(line, points);
  LineExtension(1).extend(line, points);
  EXPECT_EQ(points.size(), 5);
  EXPECT_EQ(points.position, (Numbers{1, 2.5, 5, 0, 8}));
  EXPECT_EQ(points.mass, (Numbers{10, 20, 30, 10, 30}));
}

TEST(LineExtension, FillsOtherFieldsWithTheEndValues) {
  Numbers extended(6);
  LineExtension(2).fill(Numbers{7, 9}, extended);
  EXPECT_EQ(extended, (Numbers{7, 9, 7, 7, 9, 9}));
}

TEST(LineExtension, OfOneParticleReachesToBothSides) {
  const Numbers one{2};
  Points<1> points;
  LineExtension(1).extend({one, one, one, one}, points);
  EXPECT_EQ(points.position, (Numbers{2, 0, 4}));
}

TEST_F(LineExtensionOfThree, MirrorsTheLineAtWalls) {
  const LineExtension wall(2, LineEnds::wall, 0.5, 6.5);
  wall.extend(line, points);
  EXPECT_EQ(points.position, (Numbers{1, 2.5, 5, 0, -1.5, 8, 10.5}));
  EXPECT_EQ(points.mass, (Numbers{10, 20, 30, 10, 20, 30, 20}));
  EXPECT_EQ(points.length, (Numbers{1, 2, 3, 1, 2, 3, 2}));
  Numbers velocity(7);
  wall.fill(Numbers{7, 8, 9}, velocity, Parity::odd);
  EXPECT_EQ(velocity, (Numbers{7, 8, 9, -7, -8, -9, -8}));
}

TEST_F(LineExtensionOfThree, KeepsTheSignOfVelocitiesAtFreeAndHeldEnds) {
  for (const LineEnds ends : {LineEnds::zero_gradient, LineEnds::held}) {
    Numbers velocity(5);
    LineExtension(1, ends, 0.5, 6.5).fill(Numbers{7, 8, 9}, velocity, Parity::odd);
    EXPECT_EQ(velocity, (Numbers{7, 8, 9, 7, 9}));
  }
}

}  // namespace
}  // namespace mote::test
