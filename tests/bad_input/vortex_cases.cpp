// Vortices that cannot be, and those that may not be meant.

#include "bad_input/harness.hpp"

namespace mote::test {
namespace {

/// A good vortex with some lines, counted from 1, replaced.
std::string vortex(const std::map<int, std::string>& edits) {
  static constexpr std::string_view good[] = {
      /* 1 */ "name: vortex",
      /* 2 */ "dimension: 2",
      /* 3 */ "domain: {lower: [-1, -1], upper: [1, 1]}",
      /* 4 */ "particles: {spacing: 0.1}",
      /* 5 */ "model: {type: vortex}",
      /* 6 */ "initial: {vorticity: \"exp(-9*r^2)\"}",
      /* 7 */ "operator: vortex_blob.gauss",
      /* 8 */ "time: {integrator: runge_kutta_4, step: 0.1, end: 0.2}",
      /* 9 */ "output: {picture: false}",
      /* 10 */ "check: {against: nothing}"};
  return with_edits(good, edits);
}

/// The good vortex with these options of the model.
std::string model(const std::string& options) {
  return vortex({{5, "model: {type: vortex, " + options + "}"}});
}

std::string in_a_box(const std::string& axes, std::map<int, std::string> edits) {
  edits.emplace(3, "domain: {lower: [-1, -1], upper: [1, 1], periodic: " + axes + "}");
  return vortex(edits);
}

class VortexThatCannotBe : public BadScenario {};
TEST_P(VortexThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> vortices{
    {"unknown_core", model("core: @gaus"), "unknown name 'gaus' (did you mean 'gauss'?)"},
    {"steps_that_the_integrator_chooses",
     vortex({{5, "model: {type: vortex, remesh: {every: 1}}"},
             {8, "time: {integrator: @dormand_prince_853, step: 0.1, end: 0.2}"}}),
     "dormand_prince_853 chooses its steps, which the model vortex must know before"},
    {"path_of_more_than_values",
     vortex({{5, "model: {type: vortex, remesh: {every: 1}}"},
             {8,
              "time: {integrator: runge_kutta_4, step: 0.1, end: 0.2, dense_output: "
              "@cubic_hermite}"}}),
     "the state of the model vortex as it is set up is more than values on a path, so its steps "
     "have to end at snapshots"},
    {"two_sizes", model("core: {overlap: 2, size: @0.1}"),
     "'size' and 'overlap' both say how large cores are"},
    {"size_of_a_point", model("core: {name: point, @overlap: 2}"), "unknown key 'overlap'"},
    {"diffusion_without_viscosity", model("diffusion: {type: @sph}"),
     "nothing diffuses at the viscosity 0: give 'kinematic_viscosity'"},
    {"viscosity_without_diffusion", model("kinematic_viscosity: @0.1"),
     "the viscosity has no effect without a type of 'diffusion'"},
    {"spreading_of_another_core",
     model("core: {name: @algebraic.4}, kinematic_viscosity: 0.1, diffusion: core_spreading"),
     "core_spreading needs the core 'gauss', which stays what it is as it grows"},
    {"gauss_kernel_without_spreading", model("remesh: {every: 1, kernel: @gauss}"),
     "the kernel 'gauss' makes up for core_spreading, and there is none"},
    {"vortices_on_one_place",
     model("vortices: [{position: [0, 1], circulation: 1}, {position: @[0, 1], circulation: 2}]"),
     "this vortex and number 1 stand on one place"},
    {"place_of_three_numbers", model("vortices: [{position: @[0, 1, 2], circulation: 1}]"),
     "'position' needs 2 numbers, one a dimension, and has 3"},
    {"free_stream_of_one_formula", model("free_stream: @[\"1\"]"),
     "'free_stream' needs 2 formulas, one a dimension, and has 1"},
    {"streamlines_of_vortices", vortex({{8, "time: {integrator: @x_ivas, step: 0.1, end: 0.2}"}}),
     "x_ivas does not suit the model vortex as it is set up: it needs places in two or three "
     "dimensions whose velocities it moves, too"},
    {"no_vortex", vortex({{6, "initial: {vorticity: @\"0\"}"}}),
     "there is no vortex: neither has 'initial' a vorticity, nor the model 'vortices'"},
    {"net_circulation_in_a_box",
     in_a_box("[x, y]", {{6, "initial: {vorticity: @\"1 + sin(pi*x)*sin(pi*y)\"}"}}),
     "the circulations in a periodic box must add up to 0, and here they come to 4, 1 of their "
     "magnitudes"},
    {"box_with_open_sides",
     vortex({{3, "domain: {lower: [-1, -1], upper: [1, 1], periodic: @[x]}"}}),
     "vortices need a domain that is periodic along all axes, or along none"},
    {"method_in_a_box",
     in_a_box("[x, y]", {{5, "model: {type: vortex, sum: {method: @direct}}"},
                         {6, "initial: {vorticity: \"sin(pi*x)\"}"}}),
     "a periodic box has a sum of its own, so 'method' has no effect"},
    {"core_in_a_box",
     in_a_box("[x, y]", {{5, "model: {type: vortex, core: {name: @algebraic.2}}"},
                         {6, "initial: {vorticity: \"sin(pi*x)\"}"}}),
     "vortices of a periodic box are points or have the core 'gauss'"},
    {"walls",
     vortex({{3, "domain: {lower: [-1, -1], upper: [1, 1], walls: [{side: x_lower}]}"},
             {5, "model: {type: @vortex, kinematic_viscosity: 0.1}"}}),
     "vortices flow around bodies, each of them one box, ball or polygon, and the wall 'x_lower' "
     "is none"},
    {"operator_of_circulation_elsewhere",
     vortex({{5, "model: {type: weakly_compressible, sound_speed: 10}"},
             {6, ""},
             {7, "operator: @vortex_blob.gauss"}}),
     "vortex_blob.gauss needs points with circulation, which the model weakly_compressible has "
     "not"},
    {"pair_that_is_none", vortex({{10, "check: {against: @vortex_pair}"}}),
     "vortex_pair needs two entries of 'model.vortices' and no vorticity beside them"},
    {"lamb_oseen_of_an_ellipse",
     vortex({{6, "initial: {vorticity: \"exp(-9*x^2 - 12*y^2)\"}"},
             {10, "check: {against: @lamb_oseen}"}}),
     "lamb_oseen starts from a Gauss function in a domain that holds nearly all of it"},
    {"kirchhoff_of_a_round_vortex", vortex({{10, "check: {against: @kirchhoff_ellipse}"}}),
     "kirchhoff_ellipse needs one ellipse of uniform vorticity"}};

INSTANTIATE_TEST_SUITE_P(Table, VortexThatCannotBe, testing::ValuesIn(vortices), by_label);

/// A good ring in space with some lines, counted from 1, replaced.
std::string ring(const std::map<int, std::string>& edits) {
  static constexpr std::string_view good[] = {
      /* 1 */ "name: ring",
      /* 2 */ "dimension: 3",
      /* 3 */ "domain: {lower: [-1, -1, -1], upper: [1, 1, 1]}",
      /* 4 */ "particles: {spacing: 0.1}",
      /* 5 */ "model:",
      /* 6 */ "  type: vortex",
      /* 7 */ "  core: {name: gauss, size: 0.1}",
      /* 8 */ "  rings: [{centre: [0, 0, 0], radius: 1, core: 0.3, circulation: 1}]",
      /* 9 */ "  threshold: 0.01",
      /* 10 */ "operator: sph.gauss",
      /* 11 */ "time: {integrator: runge_kutta_4, step: 0.1, end: 0.1}",
      /* 12 */ "output: {picture: false}",
      /* 13 */ "check: {against: nothing}"};
  return with_edits(good, edits);
}

std::string ring_of(const std::string& keys) { return ring({{8, "  rings: [{" + keys + "}]"}}); }

class VortexInSpaceThatCannotBe : public BadScenario {};
TEST_P(VortexInSpaceThatCannotBe, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> vortices_in_space{
    {"scalar_circulation", ring({{8, "  vortices: @[{position: [0, 0, 0], circulation: 1}]"}}),
     "in space circulation is a vector: give 'rings' or a vorticity in 'initial' in place of "
     "'vortices'"},
    {"fat_core", ring_of("centre: [0, 0, 0], radius: 1, core: @1.5, circulation: 1"),
     "the core of a ring is thinner than its radius, 1, and this is 1.5"},
    {"core_up_to_the_axis", ring_of("centre: [0, 0, 0], radius: 1, core: @0.9, circulation: 1"),
     "the core reaches the ring's axis: a higher 'threshold' ends it before"},
    {"core_thinner_than_blobs", ring_of("centre: [0, 0, 0], radius: 1, core: @0.1, circulation: 1"),
     "the blobs alone are as thick as 0.141421, and the core must be thicker, here 0.1: a smaller "
     "'spacing' or 'core.size' helps"},
    {"no_radius", ring_of("centre: [0, 0, 0], radius: @0, core: 0.3, circulation: 1"), "radius"},
    {"centre_in_the_plane", ring_of("centre: @[0, 0], radius: 1, core: 0.3, circulation: 1"),
     "three numbers are needed, and there are 2"},
    {"no_direction",
     ring_of("centre: [0, 0, 0], normal: @[0, 0, 0], radius: 1, core: 0.3, circulation: 1"),
     "'normal' has no direction"},
    {"no_vortex", ring({{8, "initial: {vorticity_x: @\"0\"}"}, {9, ""}}),
     "there is no vortex: neither has 'initial' a vorticity, nor the model 'rings'"},
    {"periodic",
     ring({{3, "domain: {lower: [-3, -3, -3], upper: [3, 3, 3], periodic: @[x, y, z]}"},
           {4, "particles: {spacing: 0.25}"}}),
     "vortices in space need a fluid without bounds"},
    {"stretching_by_another_name", ring({{9, "  stretching: @mixed"}}),
     "unknown stretching 'mixed'; there are: transposed, classical"},
    {"operator_of_one_circulation",
     ring({{9, "  threshold: 0.01\n  kinematic_viscosity: 0.01\n  diffusion: sph"},
           {10, "operator: @vortex_blob.gauss"}}),
     "this operator weighs by circulation as one number, and in space it is a vector: choose "
     "another one"},
    {"rings_in_the_plane",
     model("rings: @[{centre: [0, 0, 0], radius: 1, core: 0.1, circulation: 1}]"),
     "vortex rings need 3 dimensions"},
    {"stretching_in_the_plane", model("stretching: @classical"),
     "in the plane nothing stretches vortices"}};

INSTANTIATE_TEST_SUITE_P(Table, VortexInSpaceThatCannotBe, testing::ValuesIn(vortices_in_space),
                         by_label);

/// Negative control: the good ring runs.
TEST(VortexInSpace, Runs) {
  const Outcome outcome = Workspace(ring({})).mote(running({"--out", "out", "--quiet"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

const std::string ball =
    "{name: a, type: wall, shapes: [{type: ball, centre: [0, 0], radius: 0.5}]}";

/// The good vortex beside walls with these options of the model.
std::string beside(const std::string& walls, const std::string& options) {
  return vortex({{3, "domain: {lower: [-1, -1], upper: [1, 1]}\nregions: " + walls},
                 {5, "model: {type: vortex" + options + "}"}});
}

const std::string sticky = ", kinematic_viscosity: 0.1";

std::string box_of(const std::string& lower, const std::string& upper) {
  return "{type: box, lower: " + lower + ", upper: " + upper + "}";
}

class WallThatVorticesCannotHave : public BadScenario {};
TEST_P(WallThatVorticesCannotHave, IsRefused) { expect_refused(); }

const std::vector<ScenarioCase> walls{
    {"thin",
     beside("@[{name: a, type: wall, shapes: [" + box_of("[-0.5, -0.13]", "[0.5, 0.13]") + "]}]",
            sticky),
     "the wall 'a' is 2.6 spacings thick, and the lattice needs 3 at least"},
    {"touching",
     beside("@[{name: a, type: wall, shapes: [" + box_of("[-0.5, 0]", "[0, 0.5]") +
                "]}, {name: b, type: wall, shapes: [" + box_of("[0, 0]", "[0.5, 0.5]") + "]}]",
            sticky),
     "the walls 'a' and 'b' are 0 spacings apart, and the lattice needs 3 at least"},
    {"moving",
     beside("@[{name: a, type: wall, velocity: [\"1\", \"0\"], shapes: [" +
                box_of("[-0.5, -0.5]", "[0.5, 0.5]") + "]}]",
            sticky),
     "the wall 'a' moves, and bodies in a flow of vortices stand still"},
    {"slippery",
     beside("@[{name: a, type: wall, slip: free, shapes: [" + box_of("[-0.5, -0.5]", "[0.5, 0.5]") +
                "]}]",
            sticky),
     "the wall 'a' lets the fluid slip, and vortices come from walls where it sticks"},
    {"without_viscosity", beside("[" + ball + "]", ", kinematic_viscosity: @0"),
     "walls where the fluid sticks need a 'kinematic_viscosity'"},
    {"with_another_diffusion",
     beside("[" + ball + "]", sticky + ", diffusion: {type: @particle_strength_exchange}"),
     "beside walls vorticity spreads between the nodes of their lattice: leave 'diffusion' out"},
    {"with_another_lattice", beside("[" + ball + "]", sticky + ", remesh: {every: @2}"),
     "walls put the vortices on their lattice at the end of every step: leave 'remesh' out"},
    {"of_two_shapes",
     vortex(
         {{3,
           "domain: {lower: [-1, -1], upper: [1, 1]}\nregions: [{name: a, type: wall, shapes: [" +
               box_of("[-0.5, -0.5]", "[0, 0.5]") + ", " + box_of("[0, -0.5]", "[0.5, 0.5]") +
               "]}]"},
          {5, "model: {type: @vortex" + sticky + "}"}}),
     "vortices flow around bodies, each of them one box, ball or polygon, and the wall 'a' is "
     "none"}};
INSTANTIATE_TEST_SUITE_P(Table, WallThatVorticesCannotHave, testing::ValuesIn(walls), by_label);

/// What a run of this scenario answers.
Outcome outcome_of(const std::string& scenario) {
  return Workspace(scenario).mote(running({"--out", "out", "--quiet"}));
}

TEST(VortexOfSmallCores, IsWarnedOf) {
  const Outcome outcome = outcome_of(model("core: {overlap: 0.5}"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.errors.find(":5:29: warning: cores of 0.5 spacings do not overlap"),
            std::string::npos)
      << outcome.errors;
}

/// Negative control: the good vortex runs.
TEST(VortexOfSmallCores, IsNotEveryVortex) {
  const Outcome outcome = outcome_of(vortex({}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace mote::test
