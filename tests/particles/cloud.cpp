#include "mote/particles/cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace mote::test {
namespace {

TEST(Cloud, StartsWithPositionsAlone) {
  const Cloud cloud(3, 5);
  EXPECT_EQ(cloud.dimension(), 3);
  EXPECT_EQ(cloud.count(), 5);
  ASSERT_EQ(cloud.fields().size(), 1);
  EXPECT_EQ(cloud.fields()[0].name, "position");
  EXPECT_EQ(cloud.fields()[0].components, 3);
  EXPECT_EQ(cloud.position().size(), 15);
}

TEST(Cloud, AddsFieldsOfZerosInOrder) {
  Cloud cloud(2, 4);
  const auto velocity = cloud.add("velocity", FieldKind::vector, "m/s");
  const auto density = cloud.add("density", FieldKind::scalar, "kg/m3");
  EXPECT_EQ(velocity.size(), 8);
  EXPECT_EQ(density.size(), 4);
  EXPECT_TRUE(std::ranges::all_of(velocity, [](double v) { return v == 0; }));
  EXPECT_EQ(cloud.fields()[1].name, "velocity");
  EXPECT_EQ(cloud.fields()[2].name, "density");
  EXPECT_EQ(cloud.fields()[2].components, 1);
  EXPECT_EQ(cloud.fields()[2].si_unit, "kg/m3");
  EXPECT_TRUE(cloud.has("density"));
  EXPECT_FALSE(cloud.has("pressure"));
}

TEST(Cloud, RefusesAFieldThatItHas) {
  Cloud cloud(1, 2);
  cloud.add("mass", FieldKind::scalar, "kg");
  EXPECT_THROW(cloud.add("mass", FieldKind::vector, "kg"), std::logic_error);
  EXPECT_THROW(cloud.add("position", FieldKind::vector, "m"), std::logic_error);
  EXPECT_EQ(cloud.fields().size(), 2);
}

TEST(Cloud, RefusesAnUnknownField) {
  Cloud cloud(1, 2);
  EXPECT_THROW(cloud.values("mass"), std::out_of_range);
  EXPECT_THROW(std::as_const(cloud).values("mass"), std::out_of_range);
}

TEST(Cloud, KeepsSpansValidWhileFieldsAreAdded) {
  Cloud cloud(1, 3);
  const auto position = cloud.position();
  const auto mass = cloud.add("mass", FieldKind::scalar, "kg");
  for (int k = 0; k < 100; ++k) cloud.add("field" + std::to_string(k), FieldKind::scalar, "");
  position[2] = 7;
  mass[1] = 8;
  EXPECT_EQ(cloud.position().data(), position.data());
  EXPECT_EQ(cloud.values("mass").data(), mass.data());
  EXPECT_EQ(cloud.values("position")[2], 7);
  EXPECT_EQ(cloud.values("mass")[1], 8);
}

TEST(Cloud, KeepsSpansValidWhenItMoves) {
  Cloud cloud(2, 3);
  const auto position = cloud.position();
  const auto mass = cloud.add("mass", FieldKind::scalar, "kg");
  Cloud made = std::move(cloud);
  Cloud assigned(1, 1);
  assigned = std::move(made);
  mass[0] = 4;
  EXPECT_EQ(assigned.position().data(), position.data());
  EXPECT_EQ(assigned.values("mass").data(), mass.data());
  EXPECT_EQ(assigned.values("mass")[0], 4);
  EXPECT_EQ(assigned.count(), 3);
}

TEST(Cloud, CopiesItsValues) {
  Cloud cloud(1, 1);
  const Cloud copy = cloud;
  cloud.position()[0] = 1;
  EXPECT_EQ(copy.position()[0], 0);
}

}  // namespace
}  // namespace mote::test
