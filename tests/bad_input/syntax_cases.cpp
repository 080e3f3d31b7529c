// Files that are not YAML, or not a scenario.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

class NotAScenario : public BadScenario {};
TEST_P(NotAScenario, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> not_a_scenario{
    {"empty", "", "this file is empty"},
    {"only_comments", "# nothing\n# at all\n", "this file is empty"},
    {"only_blank_lines", "\n\n", "this file is empty"},
    {"only_null", "~\n", "this file is empty"},
    {"scalar_at_top", "@hello\n", "a scenario is a section of keys"},
    {"list_at_top", "@- name: base\n- dimension: 1\n", "a scenario is a section of keys"},
    {"flow_list_at_top", "@[name, base]\n", "a scenario is a section of keys"},
    {"two_documents", lines({}) + "@---\n" + lines({}), "a second YAML document begins here"},
    {"key_is_a_list", "? @[name]\n: base\n", "a key must be a single word"},
    {"key_is_nothing", line(12, "output: {@~: 1}"), "a key must be a single word"},
    {"merge_key", line(5, "@<<: {count: 41}\nparticles: {count: 41}"), "unknown key '<<'"}};
INSTANTIATE_TEST_SUITE_P(Table, NotAScenario, testing::ValuesIn(not_a_scenario), by_label);

class NotYaml : public BadScenario {};
TEST_P(NotYaml, IsRefused) { expect_refused(); }

// Where a closing sign is missing, the place is where YAML can no longer go on.
const std::vector<ScenarioCase> not_yaml{
    {"tab_indents", line(7, "@\tdensity: \"1\""), "tab"},
    {"bracket_not_closed", line(4, "domain: {lower: [0, upper: [L]@}"), "this is not YAML"},
    {"brace_not_closed", line(15, "  position: {a: 1") + "@", "this is not YAML"},
    {"quote_not_closed", lines({{7, "  density: \"1 + x/L"}, {8, "  velocity: \"@0\""}}),
     "this is not YAML"},
    {"indented_too_little", line(8, " @velocity: \"0\""), "this is not YAML"},
    {"colon_missing", lines({{2, "dimension 1"}, {3, "constants@: {L: 4, G: 0.0015}"}}),
     "this is not YAML"},
    {"alias_of_nothing", line(5, "particles: @*nothing"), "this is not YAML"},
    {"alias_of_itself", line(5, "particles: @&a {layout: *a, count: 41}"), "itself"},
    {"binary", std::string("\x7F\x45LF\2\1\1\0\0@", 10), "this is not YAML"},
    {"nested_too_deep", "a: " + std::string(5000, '[') + std::string(5000, ']') + "@\n", "deep"},
    {"tag", line(2, "dimension: @!degrees 1"), "tag"}};
INSTANTIATE_TEST_SUITE_P(Table, NotYaml, testing::ValuesIn(not_yaml), by_label);

class TwiceGiven : public BadScenario {};
TEST_P(TwiceGiven, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> twice_given{
    {"key", line(12, "@dimension: 1"), "the key 'dimension' is given twice"},
    {"nested_key", line(5, "particles: {count: 41, layout: regular, @count: 42}"),
     "the key 'count' is given twice"},
    {"section", line(12, "@model: {type: pressureless_gas}"), "the key 'model' is given twice"},
    {"constant", line(3, "constants: {L: 4, G: 0.0015, @L: 5}"), "the key 'L' is given twice"}};
INSTANTIATE_TEST_SUITE_P(Table, TwiceGiven, testing::ValuesIn(twice_given), by_label);

/// A message is one line of plain text, whatever the words that it quotes.
class OneLine : public BadScenario {};
TEST_P(OneLine, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> one_line{
    {"line_end_in_a_key", line(12, "@\"out\\nput\": {picture: false}"), "unknown key 'out"},
    {"line_end_in_a_word", line(5, "particles: {layout: @\"a\\nb\", count: 41}"),
     "there are: regular"},
    {"terminal_colour_in_a_word", line(5, "particles: {layout: @\"\\e[31mred\", count: 41}"),
     "there are: regular"},
    {"expression_of_two_lines", line(7, "  density: @|\n    1 +\n    foo"), "unknown name 'foo'"},
    {"line_end_in_an_expression", line(7, "  density: @\"1 +\\n foo\""), "unknown name 'foo'"}};
INSTANTIATE_TEST_SUITE_P(Table, OneLine, testing::ValuesIn(one_line), by_label);

}  // namespace
}  // namespace mote::test
