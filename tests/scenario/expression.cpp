#include "mote/scenario/expression.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace mote {
namespace {

double value(const std::string& text, const Place& place = {}) {
  return Expression(text, {{"L", 4.0}, {"G", 0.5}})(place);
}

int error_position(const std::string& text) {
  try {
    Expression(text, {});
  } catch (const ExpressionError& error) {
    return error.position();
  }
  return -1;
}

TEST(Expression, KnowsPlaceTimePiAndConstants) {
  EXPECT_EQ(value("x + 10*y + 100*z + 1000*t", {1, 2, 3, 4}), 4321);
  EXPECT_EQ(value("r", {3, 4, 12, 0}), 13);
  EXPECT_EQ(value("2*pi"), 2 * std::numbers::pi);
  EXPECT_EQ(value("L*G"), 2);
}

TEST(Expression, KnowsThePressureOfATurningSquare) {
  EXPECT_NEAR(value("square_patch(x, 2/L)", {.x = 0.5}), -0.147343, 1e-6);
  EXPECT_TRUE(Expression::is_reserved("square_patch"));
}

TEST(Expression, ClampKeepsBetween) {
  EXPECT_EQ(value("clamp(-1, 0, 1)"), 0);
  EXPECT_EQ(value("clamp(0.25, 0, 1)"), 0.25);
  EXPECT_EQ(value("clamp(7, 0, 1)"), 1);
}

TEST(Expression, ChoosesByComparison) {
  EXPECT_EQ(value("x >= 1 && x <= 2 ? 5 : 6", {1}), 5);
  EXPECT_EQ(value("x >= 1 && x <= 2 ? 5 : 6", {2.5}), 6);
}

TEST(Expression, GivesInfinityWhereTheFormulaDoes) { EXPECT_TRUE(std::isinf(value("1/x"))); }

TEST(Expression, SaysWhereItIsWrong) {
  EXPECT_EQ(error_position("1 + q"), 4);
  EXPECT_EQ(error_position("x = 2"), 2);
  EXPECT_NE(error_position("sin("), -1);
  EXPECT_THROW(value("1, 2"), ExpressionError);
  EXPECT_EQ(error_position("x <= 2"), -1);
  EXPECT_EQ(error_position("x == 2"), -1);
}

TEST(Expression, KnowsWhetherItDependsOnThePlace) {
  EXPECT_TRUE(Expression("x", {}).depends_on_place());
  EXPECT_FALSE(Expression("2*pi", {}).depends_on_place());
}

}  // namespace
}  // namespace mote
