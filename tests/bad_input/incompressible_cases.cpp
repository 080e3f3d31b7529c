// Incompressible fluids that cannot be, and those whose pressure cannot be solved for.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// A good fluid with some lines, counted from 1, replaced.
std::string fluid(const std::map<int, std::string>& edits) {
  static constexpr std::string_view good[] = {
      /* 1 */ "name: fluid",
      /* 2 */ "dimension: 2",
      /* 3 */ "domain: {lower: [0, 0], upper: [1, 1], walls: [{side: y_lower}]}",
      /* 4 */ "particles: {spacing: 0.1}",
      /* 5 */ "regions:",
      /* 6 */ "  - {name: a, type: fluid, shapes: [{type: box, lower: [0, 0], upper: [1, 0.8]}]}",
      /* 7 */ "model: {type: incompressible, gravity: [0, -9.81]}",
      /* 8 */ "operator: {family: corrected_sph, kernel: wendland_c2, smoothing_length: 1.5}",
      /* 9 */ "time: {courant: 0.2, end: 0.02}",
      /* 10 */ "output: {picture: false}"};
  return with_edits(good, edits);
}

/// The good fluid with these options of the model.
std::string model(const std::string& options) {
  return fluid({{7, "model: {type: incompressible, " + options + "}"}});
}

/// The same in a box that is periodic and full.
std::string full_box(const std::string& options) {
  return fluid({{3, "domain: {lower: [0, 0], upper: [1, 1], periodic: [x, y]}"},
                {5, "regions: []"},
                {6, ""},
                {7, "model: @{type: incompressible, " + options + "}"}});
}

class FluidThatCannotBe : public BadScenario {};
TEST_P(FluidThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> fluids{
    {"no_surface_and_no_mean_pressure", model("free_surface: @false"),
     "without a free surface nothing fixes the level of the pressure: 'mean_pressure' is needed"},
    {"streamlines_of_its_own_steps",
     fluid({{9, "time: {integrator: @x_ivas, courant: 0.2, end: 0.02}"}}),
     "the model incompressible makes its own steps, and has no integrator"},
    {"default_integrator_of_its_own_steps",
     fluid({{9, "time: {integrator: @velocity_verlet, courant: 0.2, end: 0.02}"}}),
     "the model incompressible makes its own steps, and has no integrator"},
    {"mean_pressure_at_a_surface", model("mean_pressure: @5"),
     "at a free surface the pressure is 0, so 'mean_pressure' cannot be given"},
    {"surface_that_is_not_there", full_box("density: 1"),
     "no particle is at a free surface, and nothing else fixes the level of the pressure"},
    {"particles_that_are_all_at_the_surface",
     fluid(
         {{4, "particles: @{spacing: 0.1}"},
          {6,
           "  - {name: a, type: fluid, shapes: [{type: box, lower: [0, 0.8], upper: [1, 0.9]}]}"}}),
     "no particle is well inside the fluid"},
    {"particles_that_are_too_few_to_be_inside",
     fluid({{4, "particles: @{spacing: 0.1}"},
            {6,
             "  - {name: a, type: fluid, shapes: [{type: box, lower: [0, 0.4], upper: [1, 0.6]}]}"},
            {7, "model: {type: incompressible, surface: {threshold: 0.1}}"}}),
     "n0 is that of a lattice, and the particles well inside the fluid lie "},
    {"surface_that_is_denied", model("free_surface: @false, mean_pressure: 0"),
     " of the neighbours that it has inside a fluid: is it at a free surface?"},
    {"closed_fluid_that_bears_no_tension",
     model("free_surface: false, mean_pressure: 0, tension: @false"),
     "without a free surface the fluid cannot part"},
    {"tolerance_below_rounding", model("solver: {tolerance: @1e-15}"),
     "rounding alone leaves residuals of 1e-14, and 'tolerance' is 1e-15"},
    {"gravity_of_another_dimension", model("gravity: @[0, 0, -9.81]"),
     "'gravity' needs 2 numbers, one a dimension, and has 3"},
    {"force_of_another_dimension", model("force: @[x]"),
     "'force' needs 2 formulas, one a dimension, and has 1"},
    {"unknown_solver", model("solver: {name: @jacobi}"), "unknown name 'jacobi'; there are: "},
    {"missing_neighbours_by_another_operator", model("surface: {test: @missing_neighbours}"),
     "'missing_neighbours' needs 'laplacian: mps', or the operator mps with 'constants: lattice'"},
    {"missing_neighbours_by_local_constants",
     fluid({{7, "model: {type: incompressible, surface: {test: @missing_neighbours}}"},
            {8, "operator: {family: mps, smoothing_length: 3.1}"}}),
     "'missing_neighbours' needs 'laplacian: mps', or the operator mps with 'constants: lattice'"},
    {"unknown_source", model("source: {type: @both}"),
     "unknown type 'both'; there are: divergence, density, mixed"},
    {"unknown_surface_test", model("surface: {test: @bang}"), "unknown test 'bang'"},
    {"relaxation_of_more_than_all", model("source: {relaxation: @2}"),
     "'relaxation' must be from 0 to 1, and is 2"},
    {"collisions_further_than_a_spacing", model("collisions: {distance: @2}"),
     "'distance' must be from 0 to 1, and is 2"},
    {"alone_without_a_surface",
     fluid(
         {{5,
           "regions:\n  - {name: b, type: fluid, shapes: [{type: ball, centre: [0.55, 0.95], "
           "radius: 0.05}]}"},
          {6, "  - {name: a, type: fluid, shapes: [{type: box, lower: [0, 0], upper: [1, 0.4]}]}"},
          {7, "model: {type: incompressible, free_surface: @false, mean_pressure: 0}"},
          {8, "operator: {family: mps, smoothing_length: 3.1}"}}),
     " of the neighbours that it has inside a fluid"},
    {"no_density", model("density: @0"), "'density' must be greater than 0, and is 0"},
    {"on_a_line", fluid({{2, "dimension: @1"}}), "dimension must be 2 or 3, and is 1"}};
INSTANTIATE_TEST_SUITE_P(Table, FluidThatCannotBe, testing::ValuesIn(fluids), by_label);

/// What a run of this scenario answers.
Outcome outcome_of(const std::string& scenario) {
  return Workspace(scenario).mote(running({"--out", "out", "--quiet"}));
}

void expect_failure(const std::string& scenario, const std::vector<Refusal>& refusals) {
  const Outcome outcome = outcome_of(scenario);
  for (const Refusal& refusal : refusals)
    for (const auto& fault : faults(outcome, refusal)) ADD_FAILURE() << fault;
}

TEST(FluidThatBreaksDown, TellsHowFarThePressureWasSolved) {
  const std::string beginning = "fluid: numerical failure at step 1, t = ";
  expect_failure(model("gravity: [0, -9.81], solver: {most_iterations: 1}"),
                 {{beginning, "the pressure equation was not solved: 1 iteration took the ", 3},
                  {beginning, "1e-06 was asked for (it went 0.", 3}});
}

TEST(FluidThatBreaksDown, TellsWhoseNeighboursAreTooUnevenForTheOperator) {
  expect_failure(fluid({{4, "particles: {spacing: 0.05, layout: jittered, jitter: 0.2}"},
                        {9, "time: {courant: 0.2, end: 2}"}}),
                 {{"fluid: numerical failure at step ", "the Laplacian of particle ", 3},
                  {"fluid: numerical failure at step ", "'laplacian: mps'", 3}});
}

/// Negative control: the good fluid runs.
TEST(FluidThatBreaksDown, IsNotEveryFluid) {
  const Outcome outcome = outcome_of(fluid({}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace mote::test
