#include "mote/scenario/symbolic.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "support/random.hpp"

namespace mote::test {
namespace {

/// I and Pi are numbers to GiNaC, n and gamma stand in exponents, w is negative.
const Constants constants{{"L", 4.0},     {"n", 2},   {"gamma", 1.4}, {"w", -0.7},
                          {"rho_0", 2.5}, {"I", 3.0}, {"Pi", 2.5},    {"_a", 1.5}};

std::string derivative(const std::string& formula, char variable = 'x') {
  return derivative_of(formula, variable, constants);
}

double& coordinate(Place& place, char variable) {
  return variable == 'x' ? place.x : (variable == 'y' ? place.y : place.z);
}

/// Slope of a function at 0 by central differences over h, h/2, h/4, ..., extrapolated to h = 0
/// (Richardson): the error is of order h^14, and of rounding over the last h.
double slope(const std::function<double(double)>& f) {
  std::array<double, 7> estimate{};
  double h = 0.05;
  for (std::size_t level = 0; level < estimate.size(); ++level, h /= 2) {
    double value = (f(h) - f(-h)) / (2 * h), power = 4;
    for (std::size_t k = 0; k < level; ++k, power *= 4) {
      const double finer = value + (value - estimate[k]) / (power - 1);
      estimate[k] = value;
      value = finer;
    }
    estimate[level] = value;
  }
  return estimate.back();
}

/// Whether a formula is the derivative of another at places where x, y, z, t are in [0.3, 0.9].
testing::AssertionResult is_derivative(const std::string& formula, char variable,
                                       const std::string& text) {
  const Expression f(formula, constants), derived(text, constants);
  Draws draws(31);
  for (int k = 0; k < 5; ++k) {
    Place place{draws.uniform(0.3, 0.9), draws.uniform(0.3, 0.9), draws.uniform(0.3, 0.9),
                draws.uniform(0.3, 0.9)};
    const double expected = slope([&](double shift) {
      Place moved = place;
      coordinate(moved, variable) += shift;
      return f(moved);
    });
    if (!(std::abs(derived(place) - expected) <= 1e-8 * (1 + std::abs(expected))))
      return testing::AssertionFailure() << "d/d" << variable << " (" << formula << ") is " << text
                                         << " = " << derived(place) << ", not " << expected;
  }
  return testing::AssertionSuccess();
}

struct SymbolicDerivative : testing::TestWithParam<const char*> {};

TEST_P(SymbolicDerivative, IsTheSlope) {
  for (const char variable : {'x', 'y', 'z'})
    EXPECT_TRUE(is_derivative(GetParam(), variable, derivative(GetParam(), variable)));
}

TEST_P(SymbolicDerivative, HasItsOwnDerivative) {
  for (const char first : {'x', 'y', 'z'})
    for (const char second : {'x', 'y', 'z'}) {
      const std::string once = derivative(GetParam(), first);
      EXPECT_TRUE(is_derivative(once, second, derivative(once, second)));
    }
}

TEST_P(SymbolicDerivative, IsTheSameTextInEveryCall) {
  const std::string text = derivative(GetParam());
  for (int k = 0; k < 20; ++k) EXPECT_EQ(derivative(GetParam()), text);
}

INSTANTIATE_TEST_SUITE_P(Functions, SymbolicDerivative,
                         testing::Values("sin(x*y)", "cos(x)/(2 + y)", "tan(x*z)", "asin(x/2)",
                                         "acos(x*y/2)", "atan(x - z)", "atan2(y + 1, x)",
                                         "sinh(x)*cosh(y)", "tanh(3*x)", "asinh(x*z)",
                                         "acosh(x + y + 1.5)", "atanh(x/2)", "exp(-x^2/0.5)",
                                         "ln(x + y)", "log(1 + x*z)", "log2(x + 1)", "log10(x + y)",
                                         "sqrt(x^2 + y^2 + 1)", "abs(x - 2)*y", "abs(ln(x/3))*z"));
INSTANTIATE_TEST_SUITE_P(Precedence, SymbolicDerivative,
                         testing::Values("-x^2", "2^-x*3", "x/-y*z", "x^2^y", "-2^x^2", "x--y^2",
                                         "x^-2*y^3", "(-x)^2", "x/2/y", "x - y - z^2", "x*-y^2*-z",
                                         "-(x + y)^3/-(z + 1)", "2 ^ - x ^ 2", "x/y*z",
                                         "(x + y)*(x - y)/(z - 2*x)", "(y - x - 2)^3*(z - x)^2",
                                         "+x*+y"));
INSTANTIATE_TEST_SUITE_P(Numbers, SymbolicDerivative,
                         testing::Values("0.1*x^2", "1e-3*x^3 + 1.5E+3*y", ".5*x^1.5", "2.*x^(1/3)",
                                         "x^0.1*y^-0.2", "123456789.123456789*x*y",
                                         "6.02214076e23*x^2", "1e-30*x*y", "x/3 - 2*y/7",
                                         "sqrt(2)*x^2 + acos(0)*x", "0.7", "pi^2*x"));
INSTANTIATE_TEST_SUITE_P(Names, SymbolicDerivative,
                         testing::Values("rho_0*sin(2*pi*x/L)", "x^n + y^n",
                                         "(1 + x^2/L^2)^(-gamma)", "(x + 1)^w*L", "Pi*x + I*x^2*y",
                                         "_a*x^3 + _pi*y", "r", "r^2", "1/r^n",
                                         "exp(-r^2/L)*cos(r)", "x*r*z", "sin(r - t)*t^2",
                                         "ln(r)*(x - r)", "L^x", "x^y"));

TEST(SymbolicDerivatives, CheckNoticesAWrongDerivative) {
  EXPECT_TRUE(is_derivative("x^3", 'x', "3*x^2"));
  EXPECT_FALSE(is_derivative("x^3", 'x', "3.0000003*x^2"));
  EXPECT_FALSE(is_derivative("x^3*y", 'y', "3*x^2*y"));
  EXPECT_FALSE(is_derivative("r", 'x', "1"));
}

/// GiNaC's own order of terms, and the sign of x - y, change from run to run.
TEST(SymbolicDerivatives, AreWrittenInOneOrder) {
  EXPECT_EQ(derivative("(y - x)^2"), "2*x - 2*y");
  EXPECT_EQ(derivative("(y - x)^3*z"), "-3*(x - y)^2*z");
  EXPECT_EQ(derivative("1/(2*x - 4*y)"), "-1/(2*(2*y - x)^2)");
  EXPECT_EQ(derivative("sin(y - x)"), "-cos(-x + y)");
  EXPECT_EQ(derivative("exp(-r^2)*z"), "-2*exp(-r^2)*x*z");
  EXPECT_EQ(derivative("rho_0*sin(2*pi*x/L)"), "2*cos(2*pi*x/L)*pi*rho_0/L");
  EXPECT_EQ(derivative("z*y*x*L + t*x"), "L*y*z + t");
  EXPECT_EQ(derivative("sqrt(x + y)*t"), "t/(2*sqrt(x + y))");
  EXPECT_EQ(derivative("abs(x)*x"), "2*abs(x)");
}

TEST(SymbolicDerivatives, KeepAllDigits) {
  EXPECT_EQ(derivative("0.1*x"), "1/10");
  EXPECT_EQ(derivative("1e-20*x"), "1e-20");
  EXPECT_EQ(derivative("1234567.1234567892*x"), "1234567.1234567892");
  const double value = 0.12345678901234567;
  EXPECT_EQ(Expression(derivative("0.12345678901234567*x"), {})({}), value);
}

/// Where a formula is smooth at the origin, so is its derivative as a text: no 0/0.
TEST(SymbolicDerivatives, AreFiniteAtTheOrigin) {
  for (const char* formula : {"r^2", "r^3 + 2*r^2", "exp(-r^2)*(1 + r^2)", "r^n", "x^n", "x^n*y^2"})
    EXPECT_EQ(Expression(derivative(formula), constants)({}), 0) << formula;
}

TEST(SymbolicDerivatives, TakeNestedFunctions) {
  std::string formula = "x*y", power = "x";
  for (int k = 0; k < 40; ++k) formula = "sin(" + formula + ")";
  for (int k = 0; k < 8; ++k) power = "(y - " + power + "^2)";
  for (const std::string& nested : {formula, power})
    EXPECT_TRUE(is_derivative(nested, 'x', derivative(nested)));
}

TEST(SymbolicDerivatives, OfConstantsAreZero) {
  for (const char* formula : {"5", "L", "pi*gamma", "t", "y^2", "L^gamma"})
    EXPECT_EQ(derivative(formula), "0");
}

std::string refusal(const std::string& formula, int position = -1) {
  try {
    return "accepted: " + derivative(formula);
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.position(), position) << formula;
    return error.what();
  }
}

TEST(SymbolicDerivatives, RefuseWhatHasNone) {
  EXPECT_EQ(refusal("clamp(x, 0, 1)", 0), "'clamp' has no symbolic derivative");
  EXPECT_EQ(refusal("x + min(x, 1)", 4), "'min' has no symbolic derivative");
  EXPECT_EQ(refusal("max(x, 1)", 0), "'max' has no symbolic derivative");
  EXPECT_EQ(refusal("2*rint(x)", 2), "'rint' has no symbolic derivative");
  EXPECT_EQ(refusal("x*sign(x)", 2), "'sign' has no symbolic derivative");
  EXPECT_EQ(refusal("sum(x, y)", 0), "'sum' has no symbolic derivative");
  for (const char* condition : {"x<1 ? 2 : 3", "x>=1", "x==1", "x!=1", "x&&1", "x||1"})
    EXPECT_EQ(refusal(condition, 1), "a condition has no symbolic derivative");
  EXPECT_EQ(refusal("sin(x*(x > 0))", 9), "a condition has no symbolic derivative");
}

TEST(SymbolicDerivatives, RefuseWhatIsNoRealNumber) {
  EXPECT_THAT(refusal("1/0"), testing::HasSubstr("has no symbolic derivative"));
  EXPECT_THAT(refusal("ln(-2)*x"), testing::HasSubstr("not real"));
  EXPECT_THAT(refusal("sqrt(-1 - x^2)"), testing::HasSubstr("definite nowhere"));
  EXPECT_THAT(refusal("x*2^100000"), testing::HasSubstr("too large"));
  EXPECT_THAT(refusal("1e-400*x", 0), testing::HasSubstr("'1e-400'"));
  const std::string open(300, '('), close(300, ')');
  EXPECT_THAT(refusal(open + "x" + close, 200), testing::HasSubstr("so deep"));
}

TEST(SymbolicDerivatives, RefuseWhatExpressionRefuses) {
  EXPECT_EQ(refusal("x + q", 4), "unknown name 'q'");
  EXPECT_NE(refusal("2x", 1), "accepted: 2");
  EXPECT_THROW(derivative("x, y"), ExpressionError);
  EXPECT_THROW(derivative(""), ExpressionError);
  EXPECT_THROW(derivative("x", 't'), std::invalid_argument);
}

/// To muParser, these are sums of doubles; to GiNaC, of fractions.
TEST(SymbolicDerivatives, RefuseAFormulaReadInTwoWays) {
  for (const char* formula : {"sin(x) + 1e20 - 1e20", "1e-300*(1e-300*x)*1e300*1e300"})
    EXPECT_EQ(refusal(formula), "the formula is read in two ways; its derivative must be given");
}

}  // namespace
}  // namespace mote::test
