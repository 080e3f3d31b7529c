// Keys of models in space that are given to a model on a line.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

class SpaceOnALine : public BadScenario {};
TEST_P(SpaceOnALine, IsRefused) { expect_refused(); }

const std::string here =
    " belongs to models in space, and the model pressureless_gas lives on a line";

const std::vector<ScenarioCase> keys_of_space{
    {"periodic", line(4, "domain: {lower: [0], upper: [L], periodic: @[x]}"), "'periodic'" + here},
    {"walls", line(4, "domain: {lower: [0], upper: [L], walls: @[{side: x_lower}]}"),
     "'walls'" + here},
    {"spacing", line(5, "particles: {count: 41, spacing: @0.1}"), "'spacing'" + here},
    {"spacing_alone", line(5, "particles: {spacing: @0.1}"), "'spacing'" + here},
    {"jitter", line(5, "particles: {count: 41, jitter: @0.1}"), "'jitter'" + here},
    {"layout", line(5, "particles: {count: 41, layout: @lattice}"), "'lattice'" + here},
    {"regions",
     line(12, "regions: @[{name: a, type: wall, shapes: [{type: box, lower: [0], upper: [1]}]}]"),
     "'regions'" + here},
    {"courant", line(11, "time: {step: 0.01, end: 1, courant: @0.2}"), "'courant'" + here},
    {"skin", line(12, "neighbours: {skin: @0.1}"), "'skin'" + here},
    {"search", line(12, "neighbours: {search: @kd_tree}"), "'kd_tree'" + here},
    {"search_unknown", line(12, "neighbours: {search: @grid}"),
     "unknown search 'grid'; there are: automatic, "},
    {"side_unknown", line(4, "domain: {lower: [0], upper: [L], walls: [{side: @left}]}"),
     "unknown side 'left'; there are: x_lower, x_upper"},
    {"shape_unknown",
     line(12, "regions: [{name: a, type: wall, shapes: [{type: @circle, radius: 1}]}]"),
     "unknown type 'circle'; there are: box, ball, polygon, expression"}};
INSTANTIATE_TEST_SUITE_P(Table, SpaceOnALine, testing::ValuesIn(keys_of_space), by_label);

}  // namespace
}  // namespace mote::test
