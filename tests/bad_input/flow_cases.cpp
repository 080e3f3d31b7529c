// Flows in space: domains, regions and particles that cannot be, and keys of models on a line; keys
// of models in space that are given to a model on a line.

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

/// A good flow with some lines, counted from 1, replaced.
std::string flow(const std::map<int, std::string>& edits) {
  const std::vector<std::string> good{
      /* 1 */ "name: flow",
      /* 2 */ "dimension: 2",
      /* 3 */ "domain: {lower: [0, 0], upper: [2, 1], periodic: [x], walls: [{side: y_lower}]}",
      /* 4 */ "particles: {spacing: 0.1}",
      /* 5 */ "regions: []",
      /* 6 */ "model: {type: weakly_compressible, sound_speed: 10}",
      /* 7 */ "operator: {family: sph, kernel: wendland_c2, smoothing_length: 1.5}",
      /* 8 */ "time: {end: 1}"};
  std::string text;
  for (int number = 1; number <= static_cast<int>(good.size()); ++number)
    text += (edits.contains(number) ? edits.at(number) : good[number - 1]) + '\n';
  return text;
}

std::string flow_line(int number, const std::string& text) { return flow({{number, text}}); }

const std::string water = "{name: water, type: fluid, shapes: [{type: box, lower: [0, 0], upper: ";

class FlowThatCannotBe : public BadScenario {};
TEST_P(FlowThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> flows{
    {"fluid_beyond_the_domain", flow_line(5, "regions: [@" + water + "[2, 2]}]}]"),
     "the fluid 'water' goes beyond the domain, to (0.05, 1.05)"},
    {"wall_in_the_fluid",
     flow_line(5, "regions: [" + water +
                      "[2, 1]}]}, @{name: step, type: wall, shapes: [{type: box, lower: [0.5, -1], "
                      "upper: [1.5, 0.5]}]}]"),
     "the fluid 'water' and the wall 'step' lie on top of each other at (0.55, 0.05)"},
    {"thin_wall",
     flow_line(5,
               "regions: [@{name: plate, type: wall, shapes: [{type: box, lower: [0, 0.4], upper: "
               "[2, 0.6]}]}]"),
     "the wall 'plate' is 1 spacings deep, and the operator reaches 3: the fluid would see "
     "through"},
    {"region_between_the_particles",
     flow_line(5,
               "regions: [@{name: dot, type: wall, shapes: [{type: ball, centre: [1, 0.5], "
               "radius: 0.01}]}]"),
     "the wall 'dot' has no particle in it"},
    {"polygon_that_crosses_itself",
     flow_line(5,
               "regions: [{name: bow, type: wall, shapes: [@{type: polygon, x: [0, 1, 1, 0], y: "
               "[0, 1, 0, 1]}]}]"),
     "the polygon crosses itself: the edge from (0, 0) meets the edge from (1, 0)"},
    {"wall_without_a_surface",
     flow_line(5,
               "regions: [@{name: bed, type: wall, shapes: [{type: expression, inside: \"y < 0.5 "
               "? 1 : -1\"}]}]"),
     "the surface of the wall 'bed' has no distance from"},
    {"sides_between_spacings", flow_line(4, "particles: {spacing: @0.11}"),
     "there are 18.1818 spacings along x, which must be a whole number; the nearest spacing that "
     "fits is 0.111111"},
    {"periodic_and_short",
     flow({{3, "domain: {lower: [0, 0], upper: [2, 1], periodic: @[x]}"},
           {4, "particles: {spacing: 0.4}"}}),
     "the domain is 5 spacings long along x and periodic, and the operator reaches 3 both ways"},
    {"more_particles_than_memory", flow_line(4, "particles: {spacing: @1e-7}"),
     "particles 1e-07 apart need about"},
    {"count_in_space", flow_line(4, "particles: {spacing: 0.1, count: @41}"),
     "'count' belongs to models on a line, and the model weakly_compressible lives in space"},
    {"no_spacing", flow_line(4, "particles: @{seed: 1}"),
     "section 'particles' lacks the key 'spacing'"},
    {"on_a_line", flow_line(2, "dimension: @1"), "dimension must be 2 or 3, and is 1"},
    {"wall_and_periodic",
     flow_line(3,
               "domain: {lower: [0, 0], upper: [2, 1], periodic: [x], walls: [{side: @x_lower}]}"),
     "the side x_lower cannot be a wall: the axis x is periodic"},
    {"wall_velocity_by_place",
     flow_line(
         3, "domain: {lower: [0, 0], upper: [2, 1], walls: [{side: y_lower, velocity: [t, @x]}]}"),
     "the velocity of a wall depends on t alone, and this names x"}};
INSTANTIATE_TEST_SUITE_P(Table, FlowThatCannotBe, testing::ValuesIn(flows), by_label);

}  // namespace
}  // namespace mote::test
