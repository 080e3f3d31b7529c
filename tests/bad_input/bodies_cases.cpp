// Bodies that cannot be.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// A good pair of bodies with some lines, counted from 1, replaced.
std::string bodies(const std::map<int, std::string>& edits) {
  static constexpr std::string_view good[] = {
      /* 1 */ "name: bodies",
      /* 2 */ "dimension: 3",
      /* 3 */ "domain: {lower: [-1, -1, -1], upper: [1, 1, 1]}",
      /* 4 */ "particles: {spacing: 0.1}",
      /* 5 */ "model:",
      /* 6 */ "  type: bodies",
      /* 7 */ "  masses: [{mass: 1, position: [-1, 0, 0]}, {mass: 1, position: [1, 0, 0]}]",
      /* 8 */ "  clusters: []",
      /* 9 */ "operator: sph.gauss",
      /* 10 */ "time: {integrator: velocity_verlet, step: 0.1, end: 0.2}",
      /* 11 */ "output: {picture: false}",
      /* 12 */ "check: {against: nothing}"};
  return with_edits(good, edits);
}

std::string masses(const std::string& list) { return bodies({{7, "  masses: " + list}}); }
std::string clusters(const std::string& list) { return bodies({{8, "  clusters: " + list}}); }
std::string softened(const std::string& section) {
  return bodies({{8, "  softening: " + section}});
}

/// The first of so many of the good bodies and another one, against Kepler's orbits.
std::string against_kepler(const std::string& other, int good = 2) {
  const std::string first = "{mass: 1, position: [-1, 0, 0]}, ";
  const std::string second = good == 2 ? "{mass: 1, position: [1, 0, 0]}, " : "";
  return bodies(
      {{7, "  masses: [" + first + second + other + "]"}, {12, "check: {against: @kepler}"}});
}

class BodiesThatCannotBe : public BadScenario {};
TEST_P(BodiesThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> cases{
    {"no_body", bodies({{5, "model: @{type: bodies}"}, {6, ""}, {7, ""}, {8, ""}}),
     "there is no body: give 'masses' or 'clusters'"},
    {"mass_below_nothing", masses("[{mass: @-1, position: [0, 0, 0]}]"),
     "'mass' must be at least 0, and is -1"},
    {"test_particles_alone", masses("@[{mass: 0, position: [0, 0, 0]}]"),
     "no body has a mass above 0"},
    {"radius_below_nothing", masses("[{mass: 1, position: [0, 0, 0], radius: @-1}]"),
     "'radius' must be at least 0, and is -1"},
    {"two_of_one_name",
     masses("[{name: A, mass: 1, position: [0, 0, 0]}, {name: @A, mass: 1, position: [1, 0, 0]}]"),
     "there are two masses with the name 'A'"},
    {"balls_in_contact",
     masses("[{mass: 1, position: [0, 0, 0], radius: 0.5}, "
            "{name: B, mass: 1, position: @[1, 0, 0], radius: 0.5}]"),
     "mass 1 and B are in contact at the start"},
    {"cluster_of_fewer_than_none", clusters("[{type: uniform_ball, radius: 1, count: @-3}]"),
     "'count' must be from 1 to 1000000000, and is -3"},
    {"unknown_cluster", clusters("[{type: @plumer, scale_radius: 1, count: 3}]"),
     "unknown type 'plumer' (did you mean 'plummer'?)"},
    {"radius_of_a_plummer_sphere",
     clusters("[{type: plummer, scale_radius: 1, @radius: 1, count: 3}]"), "unknown key 'radius'"},
    {"softening_without_size", softened("@{name: gauss}"),
     "section 'softening' lacks the key 'size'"},
    {"size_of_points", softened("{name: point, @size: 0.1}"), "unknown key 'size'"},
    {"unknown_softening", softened("{name: @gaus, size: 0.1}"),
     "unknown name 'gaus' (did you mean 'gauss'?)"},
    {"masses_on_one_place",
     masses("[{mass: 1, position: [0, 1, 0]}, {mass: 1, position: @[0, 1, 0]}]"),
     "mass 1 and mass 2 stand on one place"},
    {"clusters_on_one_place",
     clusters("[{type: uniform_ball, radius: 1, count: 3}, @{type: uniform_ball, radius: 1, count: "
              "3}]"),
     "a body of cluster 1 and a body of cluster 2 stand on one place"},
    {"place_of_two_numbers", masses("[{mass: 1, position: @[0, 1]}]"),
     "'position' needs 3 numbers, one a dimension, and has 2"},
    {"velocity_of_two_numbers", masses("[{mass: 1, position: [0, 1, 0], velocity: @[0, 1]}]"),
     "'velocity' needs 3 numbers, one a dimension, and has 2"},
    {"centre_of_two_numbers",
     clusters("[{type: uniform_ball, radius: 1, count: 3, centre: @[0, 1]}]"),
     "'centre' needs 3 numbers, one a dimension, and has 2"},
    {"plummer_sphere_in_the_plane",
     bodies({{2, "dimension: 2"},
             {3, "domain: {lower: [-1, -1], upper: [1, 1]}"},
             {7, ""},
             {8, "  clusters: [{type: @plummer, scale_radius: 1, count: 3}]"}}),
     "the sphere 'plummer' has 3 dimensions, this scenario has 2"},
    {"a_box", bodies({{3, "domain: {lower: [-1, -1, -1], upper: [1, 1, 1], periodic: @[x]}"}}),
     "bodies move in unbounded space, so no axis can be periodic"},
    {"walls",
     bodies({{3, "domain: {lower: [-1, -1, -1], upper: [1, 1, 1], walls: @[{side: x_lower}]}"}}),
     "the model bodies brings its own particles, and knows no walls"},
    {"another_collapse", bodies({{12, "check: {against: @cold_collapse}"}}),
     "cold_collapse needs one cluster 'uniform_ball' in 3 dimensions and no other body"},
    {"tolerance_without_control",
     bodies({{10, "time: {integrator: leapfrog_kdk, step: 0.1, end: 0.2, tolerance: @1e-9}"}}),
     "leapfrog_kdk does not control its error, so it has no tolerance"},
    {"longest_of_equal_steps",
     bodies({{10, "time: {integrator: heun, step: 0.1, end: 0.2, longest_step: @0.1}"}}),
     "heun does not choose its steps: 'step' is the longest"},
    {"tolerance_of_rounding",
     bodies({{10, "time: {integrator: dormand_prince_853, end: 0.2, tolerance: @1e-17}"}}),
     "'tolerance' must be from 1e-15 to 1, and is 1e-17"},
    {"path_that_there_is_not",
     bodies({{10, "time: {integrator: heun, step: 0.1, end: 0.2, dense_output: @own}"}}),
     "heun has no path of its own between the ends of its steps"},
    {"correction_for_more_than_two",
     bodies({{7,
              "  masses: [{mass: 1, position: [-1, 0, 0]}, {mass: 1, position: [1, 0, 0]}, "
              "{mass: 1, position: [0, 1, 0]}]"},
             {10, "time: {integrator: @contevol_1_corrected, step: 0.1, end: 0.2}"}}),
     "contevol_1_corrected does not suit the model bodies as it is set up: it needs two point "
     "masses, for its conservation correction"},
    {"planets_without_a_sun",
     bodies({{10, "time: {integrator: @wisdom_holman, step: 0.1, end: 0.2}"}}),
     "wisdom_holman does not suit the model bodies as it is set up: it needs a first body that is "
     "heavier than all others together"},
    {"kepler_of_three", against_kepler("{mass: 1, position: [0, 1, 0]}"),
     "kepler needs two bodies in 3 dimensions, and there are 3 in 3"},
    {"kepler_of_a_hyperbola",
     against_kepler("{mass: 1, position: [1, 0, 0], velocity: [0, 3, 0]}", 1),
     "kepler needs two bodies that are bound to each other: these part for ever"},
    {"kepler_on_a_line", against_kepler("{mass: 1, position: [1, 0, 0]}", 1),
     "kepler needs bodies on an ellipse: these fall on a line"},
    {"kepler_without_gravity",
     bodies({{8, "  gravitational_constant: 0"}, {12, "check: {against: @kepler}"}}),
     "kepler needs a 'gravitational_constant' above 0"},
    {"kepler_of_spread_masses",
     bodies({{8, "  softening: {name: gauss, size: 0.1}"}, {12, "check: {against: @kepler}"}}),
     "kepler is for points, and these are softened"},
    {"errors_against_nothing", bodies({{11, "output: {picture: false, errors: @true}"}}),
     "there are no errors without an exact solution"},
    {"probes_in_no_domain",
     bodies({{3, ""}, {9, "probes: @[{name: front, type: front, along: x}]"}}),
     "probes need a 'domain' to lie in"},
    {"bounds_throughout_at_a_time",
     bodies({{12, "check: {history: [@{quantity: energy, most: 1, throughout: true, at: 0.1}]}"}}),
     "'throughout' has a meaning for 'most' and 'least' without 'at' alone"},
    {"half_a_domain", bodies({{3, "domain: @{lower: [-1, -1, -1]}"}}),
     "'upper' needs 3 numbers, one a dimension, and has 0"}};

INSTANTIATE_TEST_SUITE_P(Table, BodiesThatCannotBe, testing::ValuesIn(cases), by_label);

/// Negative control: the good bodies run.
TEST(BodiesThatCanBe, Run) {
  const Outcome outcome = Workspace(bodies({})).mote(running({"--out", "out", "--quiet"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

/// They need no domain, no spacing and no operator, and their run.yaml gives the same run.
TEST(BodiesThatCanBe, LeaveOutWhatTheyDoNotNeed) {
  const Workspace workspace(bodies({{3, ""}, {4, ""}, {9, ""}}));
  EXPECT_EQ(workspace.mote(running({"--out", "out", "--quiet"})).errors, "");
  EXPECT_EQ(workspace.mote({"run", "out/run.yaml", "--out", "again", "--quiet"}).errors, "");
  EXPECT_EQ(read(workspace / "out/history.csv"), read(workspace / "again/history.csv"));
}

}  // namespace
}  // namespace mote::test
