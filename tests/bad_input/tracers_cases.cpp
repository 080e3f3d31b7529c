// Tracers that cannot be, and those that break down.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// Good tracers with some lines, counted from 1, replaced.
std::string tracers(const std::map<int, std::string>& edits) {
  static constexpr std::string_view good[] = {
      /* 1 */ "name: tracers",
      /* 2 */ "dimension: 2",
      /* 3 */ "domain: {lower: [-1, -1], upper: [1, 1]}",
      /* 4 */ "particles: {spacing: 0.25}",
      /* 5 */ "model:",
      /* 6 */ "  type: tracers",
      /* 7 */ "  velocity: ['-y', 'x']",
      /* 8 */ "  mesh: {spacing: 0.5}",
      /* 9 */ "  invariants: [{name: radius, formula: 'sqrt(x^2 + y^2)'}]",
      /* 10 */ "time: {step: 0.1, end: 0.2}",
      /* 11 */ "output: {picture: false}",
      /* 12 */ "check: {against: nothing}"};
  return with_edits(good, edits);
}

std::string velocity(const std::string& formulas) {
  return tracers({{7, "  velocity: " + formulas}});
}

std::string invariant(const std::string& name, const std::string& formula) {
  return tracers({{9, "  invariants: [{name: " + name + ", formula: " + formula + "}]"}});
}

std::string by_rates(int line, const std::string& text) {
  return tracers({{8, "  method: rates"}, {line, text}});
}

class TracersThatCannotBe : public BadScenario {};
TEST_P(TracersThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> cases{
    {"velocity_without_value", velocity("@['1/x', '0']"),
     "the velocity has no value at (0, -1) at the start"},
    {"invariant_without_value", invariant("radius", "@'sqrt(-1 - x^2)'"),
     "the invariant 'radius' has no value for the tracer that starts at (-0.875, -0.875)"},
    {"invariant_in_time", invariant("radius", "@'x + t'"),
     "'formula' is a formula in x, y, z, r alone, and this names t"},
    {"invariant_with_a_slash", invariant("@'a/b'", "'x'"),
     "'a/b' cannot name an invariant: a name is letters, digits and _"},
    {"invariant_in_the_folder_above", invariant("@'../x'", "'x'"), "cannot name an invariant"},
    {"invariant_of_two_columns", invariant("@'a,b'", "'x'"), "cannot name an invariant"},
    {"mesh_beyond_counting", tracers({{8, "  mesh: {spacing: @1e-9}"}}),
     "4e+18 points are more than a mesh can have"},
    {"mesh_beyond_memory", tracers({{8, "  mesh: {spacing: @7e-5}"}}),
     "a mesh of 8.16e+08 points needs about 816 GB, this machine has "},
    {"mesh_beyond_numbers", tracers({{8, "  mesh: {spacing: @1e-300}"}}),
     "inf points are more than a mesh can have"},
    {"operator", tracers({{11, "operator: @sph.gauss"}}),
     "the model tracers forms no derivatives, and knows no operator"},
    {"mesh_of_rates", tracers({{8, "  method: rates"}, {9, "  @mesh: {spacing: 0.5}"}}),
     "unknown key 'mesh'"},
    {"integrator_of_streamlines",
     tracers({{10, "time: {step: 0.1, end: 0.2, integrator: @velocity_verlet}"}}),
     "the model tracers makes its own steps, and has no integrator"},
    {"tolerance_of_streamlines", tracers({{10, "time: {step: 0.1, end: 0.2, tolerance: @1e-9}"}}),
     "the model tracers makes its own steps, and has no integrator with 'tolerance'"},
    {"long_steps_of_an_integrator", by_rates(10, "time: {courant: @2, end: 0.2}"),
     "'courant' must be greater than 0 and at most 1, and is 2"},
    {"no_courant_number", tracers({{10, "time: {courant: @0, end: 0.2}"}}),
     "'courant' must be greater than 0, and is 0"},
    {"exact_circles_through_a_side",
     tracers({{3, "domain: {lower: [-1, -1], upper: [1, 1], periodic: [x]}"},
              {8, "  method: rates"},
              {10, "time: {integrator: heun, step: 0.1, end: 0.2}"},
              {12, "check: {against: @circular_flow}"}}),
     "circular_flow needs circles within the domain along x, where it is periodic"},
    {"exact_rotation_through_a_side",
     tracers({{3, "domain: {lower: [-1, -1], upper: [1, 1], periodic: [x]}"},
              {8, "  method: rates"},
              {10, "time: {integrator: heun, step: 0.1, end: 0.2}"},
              {12, "check: {against: @linear_flow}"}}),
     "linear_flow needs a velocity that is the same all along x, where the domain is periodic"}};
INSTANTIATE_TEST_SUITE_P(Table, TracersThatCannotBe, testing::ValuesIn(cases), by_label);

/// Negative control: the good tracers run, and their run.yaml gives the same run.
TEST(TracersThatCanBe, Run) {
  const Workspace workspace(tracers({}));
  EXPECT_EQ(workspace.mote(running({"--out", "out", "--quiet"})).exit_code, 0);
  EXPECT_EQ(workspace.mote({"run", "out/run.yaml", "--out", "again", "--quiet"}).exit_code, 0);
  EXPECT_EQ(read(workspace / "out/history.csv"), read(workspace / "again/history.csv"));
}

TEST(TracersThatCanBe, TakeLongSteps) {
  const Workspace workspace(tracers({{10, "time: {courant: 20, end: 30}"}}));
  EXPECT_EQ(workspace.mote(running({"--out", "out", "--quiet"})).exit_code, 0);
}

/// What must be said where a run breaks down.
struct BrokenCase {
  std::string label, text, sentence;

  friend std::ostream& operator<<(std::ostream& out, const BrokenCase& c) { return out << c.label; }
};

class BrokenTracers : public testing::TestWithParam<BrokenCase> {};

TEST_P(BrokenTracers, AreAFailureThatSaysWhere) {
  const Outcome outcome = Workspace(GetParam().text).mote(running({"--out", "out", "--quiet"}));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.errors.find(GetParam().sentence), std::string::npos) << outcome.errors;
}

const std::vector<BrokenCase> broken{
    {"velocity_later", velocity("['sqrt(-t)', '0']"),
     "the velocity at the point (-1, -1) of the mesh is not a finite number"},
    {"velocity_without_square", velocity("['1e200', '0']"),
     "the square of the velocity on a streamline or of its gradient is not finite"},
    {"invariant_later",
     tracers({{7, "  velocity: ['1', '0']"},
              {9, "  invariants: [{name: radius, formula: 'sqrt(0.9 - x)'}]"}}),
     "the invariant 'radius' of tracer 7 is not a finite number"}};
INSTANTIATE_TEST_SUITE_P(Table, BrokenTracers, testing::ValuesIn(broken), by_label);

}  // namespace
}  // namespace mote::test
