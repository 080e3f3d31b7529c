// Checks of the history, and what belongs to flows, that cannot be used.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// A check of the history in place of the check of a field; `keys` may have the mark in it.
std::string check(const std::string& keys) { return line(15, "  history: [{" + keys + "}]"); }

class BadHistoryCheck : public BadScenario {};
TEST_P(BadHistoryCheck, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_history_checks{
    {"unknown_column", check("quantity: @mas, value: 1, error: 0.1"),
     "history.csv has no column 'mas' (did you mean 'mass'?); there are: time, step, mass"},
    {"no_quantity", line(15, "  history: [@{value: 1}]"), "lacks the key 'quantity'"},
    {"unknown_key", check("quantity: mass, @valu: 1"),
     "unknown key 'valu' (did you mean 'value'?)"},
    {"no_comparison", line(15, "  history: [@{quantity: mass}]"), "needs one of: 'value', "},
    {"two_comparisons", line(15, "  history: [@{quantity: mass, value: 1, most: 2}]"),
     "needs one of: 'value', "},
    {"no_error", line(15, "  history: [@{quantity: mass, value: 1}]"),
     "needs the largest relative 'error'"},
    {"error_of_a_bound", line(15, "  history: [@{quantity: mass, most: 1, error: 0.1}]"),
     "'error' has no meaning beside 'most' and 'least'"},
    {"after_the_end", check("quantity: mass, at: @2, most: 1"), "the run ends at t = 1"},
    {"time_of_a_formula", line(15, "  history: [@{quantity: mass, at: 1, formula: '1', error: 1}]"),
     "'at' has a meaning for a value"},
    {"rows_of_a_value", line(15, "  history: [@{quantity: mass, from: 1, value: 1, error: 0.1}]"),
     "'from' and 'until' have a meaning for a formula, for a curve, and with 'throughout', alone"},
    {"no_rows",
     line(15, "  history: [@{quantity: mass, from: 1, until: 0.5, formula: '1', error: 0.1}]"),
     "rows from 1 until 0.5 are none"},
    {"rows_after_the_end", check("quantity: mass, from: @2, formula: '1', error: 0.1"),
     "the run ends at t = 1"},
    {"relative_to_zero", line(15, "  history: [@{quantity: mass, value: 0, error: 0.1}]"),
     "nothing is relative to 0"},
    {"formula_of_a_place", check("quantity: mass, formula: @'1 + x', error: 0.1"), "names x"},
    {"no_such_file", check("quantity: mass, file: @none.csv, x: t, y: m, error: 0.1"), "none.csv"},
    {"no_such_column", check("quantity: mass, file: @scenario.yaml, x: t, y: m, error: 0.1"),
     "scenario.yaml:"},
    {"file_without_columns", line(15, "  history: [@{quantity: mass, file: a.csv, error: 0.1}]"),
     "needs the names of its columns"},
    {"times_and_values",
     line(15, "  history: [@{quantity: mass, times: [0, 1], values: [1], error: 0.1}]"),
     "2 times and 1 values"},
    {"curve_after_the_end",
     line(15, "  history: [@{quantity: mass, times: [2], values: [1], error: 0.1}]"),
     "no point of this curve lies within the run, until t = 1"},
    {"curve_before_the_start",
     line(15,
          "  history: [@{quantity: mass, times: [2], offset_time: 3, values: [1], error: 0.1}]"),
     "no point of this curve lies within the run, until t = 1"},
    {"unknown_norm", line(15, "  norm: @l3"), "there are: l1, l2, max"}};
INSTANTIATE_TEST_SUITE_P(Table, BadHistoryCheck, testing::ValuesIn(bad_history_checks), by_label);

class FlowOnALine : public BadScenario {};
TEST_P(FlowOnALine, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> flows_on_a_line{
    {"exact_solution", lines({{14, "  against: @taylor_green"}, {15, "  velocity: 0.01"}}),
     "taylor_green is a flow in space, and the model pressureless_gas lives on a line"},
    {"probes", line(12, "probes: @[{name: s, type: speed}]"), "probes look into flows in space"},
    {"type_of_probe", line(12, "probes: [{name: s, type: @sped}]"), "(did you mean 'speed'?)"},
    {"field_of_probe", line(12, "probes: [{name: s, type: point, at: [1], fields: [@presure]}]"),
     "(did you mean 'pressure'?)"}};
INSTANTIATE_TEST_SUITE_P(Table, FlowOnALine, testing::ValuesIn(flows_on_a_line), by_label);

}  // namespace
}  // namespace mote::test
