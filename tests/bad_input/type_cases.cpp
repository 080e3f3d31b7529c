// Values of the wrong type.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

class WrongType : public BadScenario {};
TEST_P(WrongType, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> wrong_types{
    {"text_for_number", line(2, "dimension: @one"), "'dimension' must be a number"},
    {"list_for_number", line(2, "dimension: @[1]"), "'dimension' must be a number"},
    {"section_for_number", line(2, "dimension: @{a: 1}"), "'dimension' must be a number"},
    {"flag_for_number", line(5, "particles: {count: @true}"), "'count' must be a number"},
    {"unit_for_number", line(11, "time: {step: @0.01s, end: 1}"), "unknown name 's' in '0.01s'"},
    {"number_for_section", line(5, "particles: @41"), "'particles' must be a section"},
    {"text_for_section", line(11, "time: @soon"), "'time' must be a section"},
    {"expression_for_section", lines({{6, "initial: @\"1 + x\""}, {7, ""}, {8, ""}}),
     "'initial' must be a section"},
    {"number_for_drift", line(15, "  drift: @1e-9"), "'drift' must be a section"},
    {"list_for_section", line(5, "particles: @[regular, 41]"), "'particles' must be a section"},
    {"list_for_constants", line(3, "constants: @[4]"), "'constants' must be a section"},
    {"number_for_constants", line(3, "constants: @4"), "'constants' must be a section"},
    {"text_for_constant", line(3, "constants: {L: @four, G: 1}"), "'L' must be a number"},
    {"number_for_list", line(4, "domain: {lower: @0, upper: [L]}"), "'lower' must be a list"},
    {"section_for_list", line(4, "domain: {lower: @{x: 0}, upper: [L]}"), "'lower' must be a list"},
    {"text_in_list", line(4, "domain: {lower: [@left], upper: [L]}"), "'lower' must be a number"},
    {"list_in_list", line(4, "domain: {lower: [@[0]], upper: [L]}"), "'lower' must be a number"},
    {"number_for_flag", line(12, "output: {picture: @0}"), "'picture' must be true or false"},
    {"yes_for_flag", line(12, "output: {picture: @yes}"), "'picture' must be true or false"},
    {"list_for_text", line(1, "name: @[base]"), "'name' must be a text"},
    {"empty_text", line(1, "name: @\"\""), "'name' must not be empty"},
    {"list_for_word", line(9, "model: {type: @[pressureless_gas]}"), "'type' must be a word"},
    {"list_for_expression", line(7, "  density: @[1]"), "must be a number or an expression"},
    {"section_for_expression", line(7, "  density: @{a: 1}"), "must be a number or an expression"}};
INSTANTIATE_TEST_SUITE_P(Table, WrongType, testing::ValuesIn(wrong_types), by_label);

/// A key with nothing behind it: the message names the key, not whatever follows it.
class NothingGiven : public BadScenario {};
TEST_P(NothingGiven, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> nothing_given{
    {"for_text", line(1, "@name:"), "'name' must be a text, and nothing is given"},
    {"for_number", line(2, "@dimension:"), "'dimension' must be a number, and nothing is given"},
    {"for_section", line(5, "@particles:"), "'particles' must be a section"},
    {"for_expression", line(7, "  @density:"), "and nothing is given"},
    {"for_last_section", lines({{13, "@check:"}, {14, ""}, {15, ""}}), "'check' must be a section"},
    {"null_for_number", line(11, "time: {step: @~, end: 1}"), "and nothing is given"},
    {"empty_expression", line(7, "  density: @\"\""), "empty"},
    {"empty_number", line(11, "time: {step: @\"\", end: 1}"), "empty"}};
INSTANTIATE_TEST_SUITE_P(Table, NothingGiven, testing::ValuesIn(nothing_given), by_label);

}  // namespace
}  // namespace mote::test
