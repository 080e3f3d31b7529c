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
  static constexpr std::string_view good[] = {
      /* 1 */ "name: flow",
      /* 2 */ "dimension: 2",
      /* 3 */ "domain: {lower: [0, 0], upper: [2, 1], periodic: [x], walls: [{side: y_lower}]}",
      /* 4 */ "particles: {spacing: 0.1}",
      /* 5 */ "regions: []",
      /* 6 */ "model: {type: weakly_compressible, sound_speed: 10}",
      /* 7 */ "operator: {family: sph, kernel: wendland_c2, smoothing_length: 1.5}",
      /* 8 */ "time: {end: 1}"};
  return with_edits(good, edits);
}

std::string flow_line(int number, const std::string& text) { return flow({{number, text}}); }

const std::string water = "{name: water, type: fluid, shapes: [{type: box, lower: [0, 0], upper: ";

class FlowThatCannotBe : public BadScenario {};
TEST_P(FlowThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> flows{
    {"corners_of_another_dimension", flow_line(3, "domain: {lower: @[0], upper: [2, 1]}"),
     "'lower' needs 2 numbers, one a dimension, and has 1"},
    {"fluid_beyond_the_domain", flow_line(5, "regions: [@" + water + "[2, 2]}]}]"),
     "the fluid 'water' goes beyond the domain, to (0.05, 1.05)"},
    {"wall_in_the_fluid",
     flow_line(5, "regions: [" + water +
                      "[2, 1]}]}, @{name: step, type: wall, shapes: [{type: box, lower: [0.5, -1], "
                      "upper: [1.5, 0.5]}]}]"),
     "the fluid 'water' and the wall 'step' lie on top of each other at (0.55, 0.05)"},
    {"fluids_on_top_of_each_other",
     flow_line(5, "regions: [" + water +
                      "[1, 1]}]}, @{name: oil, type: fluid, shapes: [{type: box, lower: [0.5, 0], "
                      "upper: [2, 1]}]}]"),
     "the fluid 'water' and the fluid 'oil' lie on top of each other at (0.55, 0.05)"},
    {"region_of_an_unknown_type",
     flow_line(5,
               "regions: [{name: a, type: @ice, shapes: [{type: box, lower: [0, 0], upper: [1, "
               "1]}]}]"),
     "unknown type 'ice'; there are: fluid, wall"},
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
    {"gravity_in_space",
     flow_line(6, "model: {type: weakly_compressible, sound_speed: 10, gravity: @[0, 0, -9.81]}"),
     "'gravity' needs 2 numbers, one a dimension, and has 3"},
    {"force_on_a_line",
     flow_line(6, "model: {type: weakly_compressible, sound_speed: 10, force: @[x]}"),
     "'force' needs 2 formulas, one a dimension, and has 1"},
    {"no_sound_speed", flow_line(6, "model: @{type: weakly_compressible}"),
     "section 'model' lacks the key 'sound_speed'"},
    {"negative_sound_speed", flow_line(6, "model: {type: weakly_compressible, sound_speed: @-1}"),
     "'sound_speed' must be greater than 0, and is -1"},
    {"viscosity_of_nothing",
     flow_line(6,
               "model: {type: weakly_compressible, sound_speed: 10, viscosity: @{type: morris}}"),
     "this viscosity needs 'kinematic', and it is 0"},
    {"tension_without_a_density", flow_line(5, "initial: {pressure: @\"-200\"}"),
     "no density has the pressure -200 at x = 0.05"},
    {"force_on_an_unknown_wall", flow_line(5, "probes: [{name: drag, type: force, wall: @lid}]"),
     "there is no wall 'lid'; there are: y_lower"},
    {"wall_and_periodic",
     flow_line(3,
               "domain: {lower: [0, 0], upper: [2, 1], periodic: [x], walls: [{side: @x_lower}]}"),
     "the side x_lower cannot be a wall: the axis x is periodic"},
    {"wall_velocity_by_place",
     flow_line(
         3, "domain: {lower: [0, 0], upper: [2, 1], walls: [{side: y_lower, velocity: [t, @x]}]}"),
     "the velocity of a wall depends on t alone, and this names x"}};
INSTANTIATE_TEST_SUITE_P(Table, FlowThatCannotBe, testing::ValuesIn(flows), by_label);

const std::vector<std::string> short_run{"run",   "scenario.yaml",       "--out", "out", "--quiet",
                                         "--set", "output.picture=false"};

/// A flow that runs to its end with a warning, which the summary has too; an error with --strict.
void expect_warning(const std::string& scenario, const std::string& sentence) {
  const Workspace workspace(scenario);
  const Outcome outcome = workspace.mote(short_run);
  for (const auto& fault : faults(outcome, {"flow: warning: ", sentence, 0}))
    ADD_FAILURE() << fault;
  EXPECT_NE(read(workspace / "out/summary.json").find(sentence), std::string::npos);
  std::vector<std::string> strictly = short_run;
  strictly.insert(strictly.end(), {"--strict", "--overwrite"});
  const Outcome strict = workspace.mote(strictly);
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_NE(strict.errors.find("--strict makes an error of this warning"), std::string::npos)
      << strict.errors;
}

TEST(FlowWithAWarning, HasASoundSpeedThatIsTooLow) {
  expect_warning(flow({{5, "initial: {velocity_x: \"2\"}"}, {8, "time: {end: 0.02}"}}),
                 "the sound speed 10 is less than ten times the highest speed, 2 at t = ");
}

const std::string open_below = "domain: {lower: [0, 0], upper: [2, 1], periodic: [x]}";

TEST(FlowWithAWarning, LosesParticlesThroughAHole) {
  const std::string falling = "initial: {velocity_y: \"-1\"}";
  expect_warning(flow({{3, open_below}, {5, falling}, {8, "time: {end: 0.4}"}}),
                 "20 particles left the domain and were removed, first particle 0 at (0.05, -0.3");
}

/// Negative control: a flow that is well has nothing to say.
TEST(FlowWithAWarning, IsNotEveryFlow) {
  const Outcome outcome = Workspace(flow({{8, "time: {end: 0.02}"}})).mote(short_run);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace mote::test
