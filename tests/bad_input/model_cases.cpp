// Options that each are right and do not go together, and checks that cannot be.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

class Contradiction : public BadScenario {};
TEST_P(Contradiction, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> contradictions{
    {"exact_solution_with_viscosity",
     lines({{9, "model: {type: pressureless_gas, gravity: G, viscosity: 0.01}"},
            {14, "  against: @gravitating_sheets"}}),
     "gravitating_sheets has no viscosity, this gas has"},
    {"burgers_without_viscosity", line(14, "  against: @burgers_cole_hopf"),
     "burgers_cole_hopf needs a viscosity, this gas has none"},
    {"burgers_with_gravity",
     lines({{9, "model: {type: pressureless_gas, gravity: G, viscosity: 0.01}"},
            {14, "  against: @burgers_cole_hopf"}}),
     "burgers_cole_hopf has no gravity, this gas has"},
    {"burgers_from_a_start_that_grows",
     lines({{8, "  velocity: \"-x\""},
            {9, "model: {type: pressureless_gas, viscosity: 0.01}"},
            {14, "  against: @burgers_cole_hopf"}}),
     "the start velocity grows beyond the domain"},
    {"burgers_from_a_start_that_is_no_number",
     lines({{8, "  velocity: @\"sqrt(1 + x)\""},
            {9, "model: {type: pressureless_gas, viscosity: 0.01}"},
            {14, "  against: burgers_cole_hopf"}}),
     "burgers_cole_hopf needs it on the whole line"},
    {"mass_over_volume_where_points_stand",
     line(9, "model: {type: pressureless_gas, frame: eulerian, density: @mass_over_volume}"),
     "points that stand still keep their volume"},
    {"mass_over_volume_by_differences",
     lines({{9, "model: {type: pressureless_gas, density: @mass_over_volume}"},
            {10, "operator: finite_difference"}}),
     "points that stand still keep their volume"},
    {"differences_without_extension",
     lines({{4, "domain: {lower: [0], upper: [L], extension: @0}"},
            {10, "operator: finite_difference"}}),
     "finite_difference needs 1 cell beyond each end, and 'extension' is 0"},
    {"no_neighbour_in_reach", line(10, "operator: {family: mps, smoothing_length: @0.5}"),
     "it has no neighbours"},
    {"neighbours_on_the_rim_only",
     line(10, "operator: {family: sph, kernel: lucy, smoothing_length: @1}"),
     "sph.lucy reaches 1 spacings at this smoothing length: it has no neighbours"},
    {"position_where_points_stand",
     lines({{10, "operator: finite_difference"}, {15, "  position: @0.01"}}),
     "points that stand still have no error of position"},
    {"step_past_the_next_point",
     lines({{8, "  velocity: \"1\""},
            {10, "operator: finite_difference"},
            {11, "time: {step: @0.2, end: 1}"},
            {14, "  against: nothing"},
            {15, ""}}),
     "the time in which the gas passes the shortest cell"},
    {"vortices_of_a_gas", line(10, "operator: @vortex_blob.gauss"),
     "vortex_blob.gauss needs points with circulation, which the model pressureless_gas has not"},
    {"kernel_of_mps", line(10, "operator: {family: mps, @kernel: gauss}"),
     "unknown key 'kernel' in section 'operator'"},
    {"cutoff_of_gauss", line(10, "operator: {family: sph, kernel: gauss, @cutoff: 2}"),
     "unknown key 'cutoff' in section 'operator'"},
    {"smoothing_length_of_differences",
     line(10, "operator: {family: finite_difference, @smoothing_length: 1}"),
     "unknown key 'smoothing_length' in section 'operator'"},
    {"gravity_negative", line(9, "model: {type: pressureless_gas, gravity: @-G}"),
     "'gravity' must be at least 0, and is -0.0015"},
    {"viscosity_negative", line(9, "model: {type: pressureless_gas, viscosity: @-1}"),
     "'viscosity' must be at least 0, and is -1"},
    {"burgers_of_a_smoothed_density",
     lines({{9, "model: {type: pressureless_gas, viscosity: 0.01, smoothed_density: true}"},
            {14, "  against: @burgers_cole_hopf"}}),
     "starts from the density as it is given, not smoothed"},
    {"burgers_between_walls_that_change_it",
     lines({{4, "domain: {lower: [0], upper: [L], boundary: wall}"},
            {8, "  velocity: \"0.5\""},
            {9, "model: {type: pressureless_gas, viscosity: 0.01}"},
            {14, "  against: @burgers_cole_hopf"}}),
     "only if the start velocity is odd about both"},
    {"burgers_for_too_long",
     lines({{8, "  velocity: \"1e6*sin(x)\""},
            {9, "model: {type: pressureless_gas, viscosity: 0.01}"},
            {11, "time: {step: 0.01, end: @1}"},
            {14, "  against: burgers_cole_hopf"}}),
     "the exact solution burgers_cole_hopf ends at t = "},
    {"sheets_beside_standing_points_of_a_smoothed_density",
     lines({{9,
             "model: {type: pressureless_gas, gravity: G, smoothed_density: true, frame: "
             "eulerian}"},
            {14, "  against: @gravitating_sheets"},
            {15, ""}}),
     "which start without the smoothing"},
    {"viscosity_scheme_unknown",
     line(9, "model: {type: pressureless_gas, viscosity_scheme: @implicid}"),
     "did you mean 'implicit'?"},
    {"artificial_viscosity_negative",
     line(9, "model: {type: pressureless_gas, artificial_viscosity: @-1e-7}"),
     "'artificial_viscosity' must be at least 0, and is -1e-07"},
    {"artificial_viscosity_of_masses",
     line(9,
          "model: {type: pressureless_gas, artificial_viscosity: @1e-7, density: "
          "mass_over_volume}"),
     "artificial viscosity (82) changes the density"},
    {"smoothed_density_no_flag", line(9, "model: {type: pressureless_gas, smoothed_density: @5}"),
     "smoothed_density"},
    {"boundary_unknown", line(4, "domain: {lower: [0], upper: [L], boundary: @walls}"),
     "did you mean 'wall'?"},
    {"wall_with_fewer_particles_than_it_mirrors",
     lines({{4, "domain: {lower: [0], upper: [L], boundary: wall, extension: @12}"},
            {5, "particles: {layout: regular, count: 10}"}}),
     "a wall mirrors as many particles as there are cells beyond it, 12, and there are only 10"},
    {"smoothing_length_zero",
     line(10, "operator: {family: sph, kernel: gauss, smoothing_length: @0}"),
     "'smoothing_length' must be greater than 0, and is 0"},
    {"smoothing_length_negative", line(10, "operator: {family: mps, smoothing_length: @-2}"),
     "'smoothing_length' must be greater than 0, and is -2"},
    {"cutoff_zero", line(10, "operator: {family: sph, kernel: truncated_gauss, cutoff: @0}"),
     "'cutoff' must be from 0.1 to 100, and is 0"},
    {"cutoff_huge", line(10, "operator: {family: sph, kernel: truncated_gauss, cutoff: @1e9}"),
     "'cutoff' must be from 0.1 to 100, and is 1000000000"}};
INSTANTIATE_TEST_SUITE_P(Table, Contradiction, testing::ValuesIn(contradictions), by_label);

class BadLimit : public BadScenario {};
TEST_P(BadLimit, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_limits{
    {"negative", line(15, "  position: @-0.01"), "'position' must be greater than 0, and is -0.01"},
    {"zero", line(15, "  position: @0"), "'position' must be greater than 0, and is 0"},
    {"nan", line(15, "  position: @.nan"), "finite decimal number, not '.nan'"},
    {"infinite", line(15, "  position: @.inf"), "finite decimal number, not '.inf'"},
    {"text", line(15, "  position: @small"), "'position' must be a number"},
    {"drift_negative", line(15, "  drift: {mass: @-1e-9}"), "'mass' must be greater than 0"},
    {"where_points_stand", line(15, "  eulerian: {density: @-1}"),
     "'density' must be greater than 0"}};
INSTANTIATE_TEST_SUITE_P(Table, BadLimit, testing::ValuesIn(bad_limits), by_label);

/// The name becomes the name of a folder in results/.
class BadName : public BadScenario {};
TEST_P(BadName, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> bad_names{
    {"leads_out_of_the_folder", line(1, "name: @../base"), "name"},
    {"is_the_folder_above", line(1, "name: @.."), "name"},
    {"is_an_absolute_path", line(1, "name: @/tmp/base"), "name"},
    {"is_too_long_for_a_folder", line(1, "name: @" + std::string(300, 'a')), "name"}};
INSTANTIATE_TEST_SUITE_P(Table, BadName, testing::ValuesIn(bad_names), by_label);

}  // namespace
}  // namespace mote::test
