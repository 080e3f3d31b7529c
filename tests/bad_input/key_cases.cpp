// Keys and words that mote does not know, keys that it misses, and values of the wrong type.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

class UnknownKey : public BadScenario {};
TEST_P(UnknownKey, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> unknown_keys{
    {"particles", line(5, "@partcles: {layout: regular, count: 41}"),
     "unknown key 'partcles' (did you mean 'particles'?)"},
    {"capital_letter", line(1, "@Name: base"), "unknown key 'Name' (did you mean 'name'?)"},
    {"like_nothing", line(12, "@colour: red"), "unknown key 'colour' in the scenario"},
    {"model", line(9, "@modell: {type: pressureless_gas, gravity: G}"),
     "unknown key 'modell' (did you mean 'model'?)"},
    {"constants", line(3, "@constnts: {L: 4, G: 0.0015}"),
     "unknown key 'constnts' (did you mean 'constants'?)"},
    {"initial", line(6, "@intial:"), "unknown key 'intial' (did you mean 'initial'?)"},
    {"operator", line(10, "@oprator: sph.gauss"),
     "unknown key 'oprator' (did you mean 'operator'?)"},
    {"layout", line(5, "particles: {@layuot: regular, count: 41}"),
     "unknown key 'layuot' (did you mean 'layout'?) in section 'particles'"},
    {"count_letters_swapped", line(5, "particles: {layout: regular, @cuont: 41}"),
     "unknown key 'cuont' (did you mean 'count'?) in section 'particles'"},
    {"type", line(9, "model: {@typ: pressureless_gas, gravity: G}"),
     "unknown key 'typ' (did you mean 'type'?) in section 'model'"},
    {"gravity", line(9, "model: {type: pressureless_gas, @gravty: G}"),
     "unknown key 'gravty' (did you mean 'gravity'?) in section 'model'"},
    {"family", line(10, "operator: {@familiy: sph, kernel: gauss}"),
     "unknown key 'familiy' (did you mean 'family'?) in section 'operator'"},
    {"kernel", line(10, "operator: {family: sph, @kernl: gauss}"),
     "unknown key 'kernl' (did you mean 'kernel'?) in section 'operator'"},
    {"step", line(11, "time: {@stp: 0.01, end: 1}"), "unknown key 'stp' (did you mean 'step'?)"},
    {"every", line(12, "output: {@evry: 0.5}"), "unknown key 'evry' (did you mean 'every'?)"},
    {"initial_field", line(7, "  @densty: \"1\""),
     "unknown key 'densty' (did you mean 'density'?) in section 'initial'"},
    {"field_of_no_model", line(8, "  @pressure: \"1\""),
     "unknown key 'pressure' in section 'initial'"},
    {"checked_field", line(15, "  @pressure: 0.01"), "unknown key 'pressure' in section 'check'"},
    {"checked_without_solution", lines({{14, "  against: nothing"}, {15, "  @density: 0.01"}}),
     "unknown key 'density' in section 'check'"},
    {"checked_where_points_stand", line(15, "  eulerian: {@position: 0.01}"),
     "unknown key 'position' in section 'eulerian'"},
    {"drift", line(15, "  drift: {@mas: 1}"), "unknown key 'mas' (did you mean 'mass'?)"}};
INSTANTIATE_TEST_SUITE_P(Table, UnknownKey, testing::ValuesIn(unknown_keys), by_label);

class UnknownWord : public BadScenario {};
TEST_P(UnknownWord, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> unknown_words{
    {"type", line(9, "model: {type: @presureless_gas}"), "(did you mean 'pressureless_gas'?)"},
    {"family", line(10, "operator: {family: @spf, kernel: gauss}"), "(did you mean 'sph'?)"},
    {"kernel", line(10, "operator: {family: sph, kernel: @gaus}"), "(did you mean 'gauss'?)"},
    {"kernel_in_short", line(10, "operator: @sph.gaus"), "(did you mean 'gauss'?)"},
    {"family_in_short", line(10, "operator: @vortex"), "there are: sph, morris, "},
    {"third_word_in_short", line(10, "operator: @sph.gauss.fast"), "'fast'"},
    {"kernel_of_mps_in_short", line(10, "operator: @mps.gauss"), "'gauss'"},
    {"layout", line(5, "particles: {layout: @reglar, count: 41}"), "(did you mean 'regular'?)"},
    {"integrator", line(11, "time: {integrator: @rk4, step: 0.01, end: 1}"),
     "there are: forward_euler, symplectic_euler, velocity_verlet, "},
    {"integrator_with_hyphen", line(11, "time: {integrator: @velocity-verlet, step: 0.01, end: 1}"),
     "(did you mean 'velocity_verlet'?)"},
    {"exact_solution", line(14, "  against: @gravitating_sheet"),
     "(did you mean 'gravitating_sheets'?)"},
    {"units", line(12, "units: @CGS"), "there are: none, SI"},
    {"boundary", line(4, "domain: {lower: [0], upper: [L], boundary: @periodic}"),
     "there are: zero_gradient"},
    {"gravity_form", line(9, "model: {type: pressureless_gas, gravity_form: @sheet}"),
     "(did you mean 'sheets'?)"}};
INSTANTIATE_TEST_SUITE_P(Table, UnknownWord, testing::ValuesIn(unknown_words), by_label);

class MissingKey : public BadScenario {};
TEST_P(MissingKey, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> missing_keys{
    {"name", line(1, ""), "the scenario lacks the key 'name'"},
    {"dimension", line(2, ""), "the scenario lacks the key 'dimension'"},
    {"constants",
     lines({{3, ""},
            {4, "domain: {lower: [0], upper: [@L]}"},
            {9, "model: {type: pressureless_gas}"}}),
     "unknown name 'L'"},
    {"domain", line(4, ""), "the scenario lacks the key 'domain'"},
    {"particles", line(5, ""), "the scenario lacks the key 'particles'"},
    {"initial", lines({{6, ""}, {7, ""}, {8, ""}}), "the scenario lacks the key 'initial'"},
    {"model", line(9, ""), "the scenario lacks the key 'model'"},
    {"operator", line(10, ""), "the scenario lacks the key 'operator'"},
    {"time", line(11, ""), "the scenario lacks the key 'time'"},
    {"lower", line(4, "domain: @{upper: [L]}"), "section 'domain' lacks the key 'lower'"},
    {"count", line(5, "particles: @{}"), "section 'particles' lacks the key 'count'"},
    {"density", lines({{7, ""}, {8, "  @velocity: \"0\""}}), "'initial' lacks the key 'density'"},
    {"type", line(9, "model: @{gravity: G}"), "section 'model' lacks the key 'type'; there are: "},
    {"family", line(10, "operator: @{}"), "section 'operator' lacks the key 'family'"},
    {"kernel", line(10, "operator: @{family: sph}"), "section 'operator' lacks the key 'kernel'"},
    {"kernel_in_short", line(10, "operator: @sph"), "section 'operator' lacks the key 'kernel'"},
    {"step", line(11, "time: @{end: 1}"), "section 'time' lacks the key 'step'"},
    {"end", line(11, "time: @{step: 0.01}"), "section 'time' lacks the key 'end'"}};
INSTANTIATE_TEST_SUITE_P(Table, MissingKey, testing::ValuesIn(missing_keys), by_label);

}  // namespace
}  // namespace mote::test
