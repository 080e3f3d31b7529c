// Expressions that cannot be read, or have no value where a particle is.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

std::string density(const std::string& expression) {
  return line(7, "  density: @'" + expression + "'");
}

std::string velocity(const std::string& expression) {
  return line(8, "  velocity: @'" + expression + "'");
}

class BadExpression : public BadScenario {};
TEST_P(BadExpression, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_expressions{
    {"unknown_name", density("1 + y0"), "unknown name 'y0' at character 5 of '1 + y0'"},
    {"unknown_function", density("foo(1)"), "unknown name 'foo' at character 1"},
    {"unknown_name_of_other_letters", density("1 + \xCE\xB1 + x"), "unknown name '\xCE\xB1'"},
    {"other_field", density("velocity"), "unknown name 'velocity'"},
    {"ends_too_early", density("1 +"), "the expression ends too early at character"},
    {"parenthesis_not_closed", density("1 + (x"), "parenthesis"},
    {"condition_without_else", density("x == 3 ? 1"), "else"},
    {"two_operators", density("x**2"), "at character 3"},
    {"two_values", density("1 2"), "at character 3"},
    {"two_expressions", density("1, 2"), "this is several expressions"},
    {"two_statements", density("1; 2"), "at character 2"},
    {"too_few_arguments", density("sin()"), "sin"},
    {"too_many_arguments", density("sin(1, 2)"), "sin"},
    {"text", density("\"one\""), "'density'"},
    {"assignment", density("x = 3"), "'=' assigns; a comparison is '==' at character 3"},
    {"assignment_with_sum", density("x += 2"), "'=' assigns; a comparison is '=='"},
    {"assignment_to_a_constant", density("L = 3"), "'=' assigns; a comparison is '=='"},
    {"nan", density("nan"), "finite decimal number, not 'nan'"},
    {"infinite", density(".inf"), "finite decimal number, not '.inf'"},
    {"too_large_for_a_double", density("1e400"), "finite"},
    {"hexadecimal", density("0x10"), "decimal number, not '0x10'"}};
INSTANTIATE_TEST_SUITE_P(Table, BadExpression, testing::ValuesIn(bad_expressions), by_label);

class NoValue : public BadScenario {};
TEST_P(NoValue, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> without_value{
    {"density_over_zero", density("1/(x - x)"), "'density' is inf at x = 0.0487805"},
    {"density_over_zero_at_one_particle", density("1 + 1/abs(x - 2)"), "'density' is inf at x = 2"},
    {"density_log_of_minus_one", density("log(-1)"), "at x = 0.0487805"},
    {"density_negative", density("-1"), "the density must be positive everywhere, and is -1 at"},
    {"density_negative_on_the_left", density("x - 2"),
     "the density must be positive everywhere, and is -1.95122 at x = 0.0487805"},
    {"density_zero_on_the_left", density("x < 2 ? 0 : 1"),
     "the density must be positive everywhere, and is 0 at x = 0.0487805"},
    {"density_too_large", density("1e308*10"), "'density' is inf"},
    {"velocity_over_zero_at_the_end", velocity("1/x"), "'velocity' is inf at x = 0"},
    {"velocity_log_of_minus", velocity("log(x - 2)"), "'velocity' is"}};
INSTANTIATE_TEST_SUITE_P(Table, NoValue, testing::ValuesIn(without_value), by_label);

class BadConstantName : public BadScenario {};
TEST_P(BadConstantName, IsRefused) { expect_refused(); }

ScenarioCase constant(const std::string& label, const std::string& name) {
  return {label, line(3, "constants: {L: 4, G: 0.0015, @" + name + ": 1}"),
          "'" + name + "' cannot name a constant"};
}

const std::vector<ScenarioCase> bad_constant_names{constant("x", "x"),
                                                   constant("t", "t"),
                                                   constant("r", "r"),
                                                   constant("pi", "pi"),
                                                   constant("a_function", "clamp"),
                                                   constant("a_digit_first", "2a"),
                                                   constant("a_hyphen", "a-b"),
                                                   constant("a_space", "a b"),
                                                   constant("a_letter_not_in_ascii", "\xC3\xA9")};
INSTANTIATE_TEST_SUITE_P(Table, BadConstantName, testing::ValuesIn(bad_constant_names), by_label);

}  // namespace
}  // namespace mote::test
