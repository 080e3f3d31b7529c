// Numbers that are not numbers, or that no run can have.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

std::string step(const std::string& number) {
  return line(11, "time: {integrator: symplectic_euler, step: @" + number + ", end: 1}");
}

std::string end(const std::string& number) {
  return line(11, "time: {integrator: symplectic_euler, step: 0.01, end: @" + number + "}");
}

std::string count(const std::string& number) {
  return line(5, "particles: {layout: regular, count: @" + number + "}");
}

std::string domain(const std::string& lower, const std::string& upper) {
  return line(4, "domain: {lower: " + lower + ", upper: " + upper + "}");
}

class BadNumber : public BadScenario {};
TEST_P(BadNumber, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_numbers{
    {"negative", step("-0.01"), "'step' must be greater than 0, and is -0.01"},
    {"zero", step("0"), "'step' must be greater than 0, and is 0"},
    {"nan", step(".nan"), "finite decimal number, not '.nan'"},
    {"nan_as_a_word", step("NaN"), "finite decimal number, not 'NaN'"},
    {"infinite", step(".inf"), "finite decimal number, not '.inf'"},
    {"minus_infinite", step("-.inf"), "finite decimal number, not '-.inf'"},
    {"infinite_as_a_word", step("inf"), "finite decimal number, not 'inf'"},
    {"too_large_for_a_double", step("1e400"), "finite"},
    {"one_over_zero", step("1/0"), "'step' must be finite"},
    {"zero_over_zero", step("0/0"), "'step' must be finite"},
    {"root_of_minus_one", step("sqrt(-1)"), "'step' must be finite"},
    {"hexadecimal", step("0x1"), "decimal number, not '0x1'"},
    {"binary", step("0b1"), "decimal number, not '0b1'"},
    {"leading_zero", step("010"), "decimal number, not '010'"},
    {"underscore", step("1_000"), "'step' must be a number"},
    {"two_points", step("0.0.1"), "'step' must be a number"},
    {"two_numbers", step("1 2"), "'step' must be a number"},
    {"depends_on_x", step("x/100"), "it cannot depend on x, y, z, r or t"},
    {"end_negative", end("-1"), "'end' must be greater than 0, and is -1"},
    {"end_zero", end("0"), "'end' must be greater than 0, and is 0"},
    {"end_nan", end(".nan"), "finite decimal number"},
    {"constant_infinite", line(3, "constants: {L: @1/0, G: 0.0015}"), "'L' must be finite"},
    {"constant_of_a_later_one", line(3, "constants: {L: @2*G, G: 2}"), "unknown name 'G'"},
    {"constant_of_itself", line(3, "constants: {L: @L, G: 2}"), "unknown name 'L'"}};
INSTANTIATE_TEST_SUITE_P(Table, BadNumber, testing::ValuesIn(bad_numbers), by_label);

class BadCount : public BadScenario {};
TEST_P(BadCount, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_counts{
    {"one", count("1"), "'count' must be from 2 to 2000000000, and is 1"},
    {"none", count("0"), "'count' must be from 2"},
    {"negative", count("-41"), "'count' must be from 2"},
    {"fraction", count("40.5"), "'count' must be a whole number"},
    {"fraction_by_expression", count("L/3*10"), "'count' must be a whole number"},
    {"octal", count("041"), "not '041'"},
    {"hexadecimal", count("0x29"), "not '0x29'"},
    {"more_than_the_memory_holds", count("2e9"), "2000000000 particles need about 1072 GB"},
    {"more_than_an_index_holds", count("2e10"), "'count' must be from 2 to 2000000000"},
    {"huge", count("1e300"), "'count' must be from 2 to 2000000000"},
    {"closer_than_numbers_can_tell", line(5, "particles: {layout: geometric, count: @2000}"),
     "closer than numbers can tell"},
    {"seed_negative", line(5, "particles: {layout: random, count: 41, seed: @-1}"),
     "'seed' must be at least 0"},
    {"seed_beyond_whole_numbers", line(5, "particles: {layout: random, count: 41, seed: @1e17}"),
     "'seed' must be a whole number below 9e15"},
    {"extension_negative", line(4, "domain: {lower: [0], upper: [L], extension: @-1}"),
     "'extension' must be from 0 to 1000000"},
    {"extension_fraction", line(4, "domain: {lower: [0], upper: [L], extension: @1.5}"),
     "'extension' must be a whole number"},
    {"extension_huge", line(4, "domain: {lower: [0], upper: [L], extension: @1e7}"),
     "'extension' must be from 0 to 1000000"},
    {"history_negative", line(12, "output: {history: @-1}"), "'history' must be at least 0"},
    {"history_fraction", line(12, "output: {history: @1.5}"), "'history' must be a whole number"},
    {"threads_negative", line(12, "threads: @-1"), "'threads' must be from 0 to 4096"},
    {"threads_in_words", line(12, "threads: @all"), "'threads' must be a number"}};
INSTANTIATE_TEST_SUITE_P(Table, BadCount, testing::ValuesIn(bad_counts), by_label);

class BadDomain : public BadScenario {};
TEST_P(BadDomain, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_domains{
    {"upper_below_lower", domain("[0]", "@[-1]"), "the upper corner -1 must lie above the lower 0"},
    {"upper_equals_lower", domain("[4]", "@[L]"), "the upper corner 4 must lie above the lower 4"},
    {"corner_of_two", domain("@[0, 0]", "[L]"),
     "'lower' needs 1 number, one a dimension, and has 2"},
    {"corner_of_none", domain("[0]", "@[]"), "'upper' needs 1 number, one a dimension, and has 0"},
    {"corner_infinite", domain("[0]", "[@.inf]"), "finite decimal number, not '.inf'"},
    {"wider_than_a_double", domain("[-1e308]", "@[1e308]"), "upper"},
    {"no_room_for_particles",
     lines({{4, "domain: {lower: [1], upper: [1.0000000000000002]}"},
            {5, "particles: {layout: regular, count: @41}"}}),
     "closer than numbers can tell"},
    {"dimension_0", line(2, "dimension: @0"), "'dimension' must be from 1 to 3, and is 0"},
    {"dimension_4", line(2, "dimension: @4"), "'dimension' must be from 1 to 3, and is 4"},
    {"dimension_fraction", line(2, "dimension: @1.5"), "'dimension' must be a whole number"},
    {"dimension_2_with_corners_of_1",
     lines({{2, "dimension: @2"}, {4, "domain: {lower: [0], upper: [L]}"}}),
     "the model pressureless_gas lives on a line: dimension must be 1, and is 2"},
    {"dimension_2", lines({{2, "dimension: @2"}, {4, "domain: {lower: [0, 0], upper: [L, L]}"}}),
     "the model pressureless_gas lives on a line: dimension must be 1, and is 2"}};
INSTANTIATE_TEST_SUITE_P(Table, BadDomain, testing::ValuesIn(bad_domains), by_label);

class BadPlan : public BadScenario {};
TEST_P(BadPlan, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_plans{
    {"step_beyond_the_stability_limit", step("8"),
     "the step 8 is beyond the stability limit 7.306"},
    {"too_many_steps", step("1e-13"), "are more than 1e12"},
    {"end_beyond_the_exact_solution", end("30"),
     "the exact solution gravitating_sheets ends at t = 7.30596, before the run does at t = 30"},
    {"snapshots_never", line(12, "output: {every: @0}"), "'every' must be greater than 0"},
    {"snapshots_back_in_time", line(12, "output: {every: @-1}"), "'every' must be greater than 0"},
    {"too_many_snapshots", line(12, "output: {every: @1e-9}"), "more than a million"}};
INSTANTIATE_TEST_SUITE_P(Table, BadPlan, testing::ValuesIn(bad_plans), by_label);

}  // namespace
}  // namespace mote::test
