// Whole runs of vortices: the same bits by any way.

#include "flow_runs.hpp"

namespace mote::test {
namespace {

/// Blobs that are put on a lattice and exchange circulation, in numbers for several threads.
constexpr const char* exchanging = R"yaml(name: exchanging
dimension: 2
domain: {lower: [-1, -1], upper: [1, 1]}
particles: {spacing: 0.025, layout: jittered, jitter: 0.2}
model:
  type: vortex
  sum: {method: direct}
  kinematic_viscosity: 0.001
  diffusion: particle_strength_exchange
  remesh: {every: 3}
  threshold: 1e-4
  free_stream: ["0.1*cos(t)", "0"]
initial: {vorticity: "10*exp(-6*(x^2 + 3*y^2))"}
operator: sph.gauss
time: {integrator: runge_kutta_4, step: 0.02, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// In a box, by an operator.
constexpr const char* boxed = R"yaml(name: boxed
dimension: 2
domain: {lower: [0, 0], upper: [1, 1], periodic: [x, y]}
particles: {spacing: 0.02}
model: {type: vortex, kinematic_viscosity: 0.01, diffusion: sph, remesh: {every: 2}}
initial: {vorticity: "sin(2*pi*x)*sin(2*pi*y)"}
operator: corrected_sph.wendland_c2
time: {integrator: predictor_corrector, step: 0.02, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// Vortices that move at random, and steps that follow the strongest of them.
constexpr const char* walking = R"yaml(name: walking
dimension: 2
domain: {lower: [-1, -1], upper: [1, 1]}
particles: {spacing: 0.025}
model:
  {type: vortex, core: {name: algebraic.4}, kinematic_viscosity: 0.001,
   diffusion: {type: random_walk, seed: 3}}
initial: {vorticity: "10*exp(-6*(x^2 + 3*y^2))"}
operator: sph.gauss
time: {integrator: forward_euler, courant: 0.3, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// Cores that grow, and give what they have grown by back to the lattice.
constexpr const char* spreading = R"yaml(name: spreading
dimension: 2
domain: {lower: [-1, -1], upper: [1, 1]}
particles: {spacing: 0.05}
model:
  type: vortex
  sum: {method: direct}
  kinematic_viscosity: 0.05
  diffusion: core_spreading
  remesh: {every: 1, kernel: gauss}
initial: {vorticity: "10*exp(-6*(x^2 + 3*y^2))"}
operator: sph.gauss
time: {integrator: runge_kutta_4, step: 0.02, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// Two rings in space that exchange circulation, by the multipole method.
constexpr const char* rings = R"yaml(name: rings
dimension: 3
domain: {lower: [-1, -1, -1], upper: [1, 1, 1]}
particles: {spacing: 0.1}
model:
  type: vortex
  core: {name: gauss, overlap: 1.2}
  sum: {method: multipole, tolerance: 1e-4}
  kinematic_viscosity: 0.001
  diffusion: particle_strength_exchange
  threshold: 0.01
  rings:
    - {centre: [0, 0, 0], radius: 1, core: 0.25, circulation: 1}
    - {centre: [0, 0, 0.6], normal: [0, 0.2, 1], radius: 1, core: 0.25, circulation: 1}
operator: sph.gauss
time: {integrator: runge_kutta_4, step: 0.05, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// Vorticity by formulas in space, put on a lattice.
constexpr const char* formulas = R"yaml(name: formulas
dimension: 3
domain: {lower: [-1, -1, -1], upper: [1, 1, 1]}
particles: {spacing: 0.2}
model: {type: vortex, sum: {method: direct}, stretching: classical, remesh: {every: 2}, threshold: 1e-3}
initial: {vorticity_x: "-y*exp(-6*r^2)", vorticity_y: "x*exp(-6*r^2)", vorticity_z: "exp(-9*r^2)"}
operator: sph.gauss
time: {integrator: runge_kutta_4, step: 0.05, end: 0.2}
output: {every: 0.05, picture: false}
)yaml";

/// Bodies that a stream meets at once.
constexpr const char* beside_walls = R"yaml(name: beside_walls
dimension: 2
domain: {lower: [-1, -1], upper: [1, 1]}
particles: {spacing: 0.05}
regions:
  - {name: ball, type: wall, shapes: [{type: ball, centre: [-0.5, 0], radius: 0.2}]}
  - {name: wedge, type: wall, shapes: [{type: polygon, x: [0.2, 0.7, 0.7], y: [0, -0.3, 0.4]}]}
model:
  type: vortex
  core: {name: algebraic.4, overlap: 0.7}
  kinematic_viscosity: 0.01
  threshold: 1e-6
  free_stream: ["1", "0.1*t"]
operator: sph.gauss
time: {integrator: predictor_corrector, step: 0.05, end: 0.4}
probes: [{name: on_ball, type: force, wall: ball}]
output: {every: 0.1, history: 1, picture: false}
)yaml";

/// A cylinder at Re 1000 that a stream meets at once, and what its drag is (Bar-Lev & Yang 1975).
constexpr const char* started_cylinder = R"yaml(name: started_cylinder
dimension: 2
constants: {Re: 1000, nu: 2/Re, dt: 0.01}
domain: {lower: [-1.5, -1.5], upper: [1.5, 1.5]}
particles: {spacing: 1/80}
regions: [{name: cylinder, type: wall, shapes: [{type: ball, centre: [0, 0], radius: 1}]}]
model:
  type: vortex
  core: {name: algebraic.4, overlap: 0.7}
  kinematic_viscosity: nu
  threshold: 1e-6
  free_stream: ["1", "0"]
operator: sph.gauss
time: {integrator: predictor_corrector, step: dt, end: 0.1}
output: {every: 0.1, history: 1, picture: false}
check:
  history:
    - {quantity: force_x, from: 0.035, formula: "4*sqrt(2*pi/(Re*(t - dt/2)))", error: 0.05}
    - {quantity: force_y, most: 1e-8, least: -1e-8}
)yaml";

struct StartedCylinder : FlowRuns {};

TEST_F(StartedCylinder, HasTheDragOfItsViscosity) { run(started_cylinder, "out"); }

TEST_F(StartedCylinder, HasNotThatOfAnother) {
  write(folder_ / "scenario.yaml", started_cylinder);
  const Outcome outcome =
      mote({"run", (folder_ / "scenario.yaml").string(), "--out", (folder_ / "out").string(),
            "--quiet", "--set", "model.kinematic_viscosity=1.2*nu"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
}

struct VortexRun : FlowRuns, testing::WithParamInterface<const char*> {};

TEST_P(VortexRun, HasTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits_for_any_number_of_threads(GetParam());
}

TEST_P(VortexRun, HasTheSameBitsAfterAResume) {
  expect_same_bits_after_a_resume(GetParam(), {"1", "4"});
}

/// Negative control of the comparisons above.
TEST_P(VortexRun, HasOtherBitsWithAnotherThreshold) {
  const fs::path one = run(GetParam(), "one");
  const fs::path other = run(GetParam(), "other", {"--set", "model.threshold=0.002"});
  EXPECT_NE(read(one / frames.back()), read(other / frames.back()));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, VortexRun,
                         testing::Values(exchanging, boxed, walking, spreading, rings, formulas,
                                         beside_walls));

}  // namespace
}  // namespace mote::test
