// How a weakly compressible flow runs: steps, threads, searches, restarts, memory and warnings.

#include <gmock/gmock.h>
#include <omp.h>

#include "counted_memory.hpp"
#include "support/flow_case.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Water that begins to fall in a tank whose lower wall shakes, with all that a flow can do.
FlowCase busy_tank(double spacing) {
  FlowCase flow = flow_in_a_box(2, spacing, {0.8, 0.6});
  flow.plan.upper = {1, 1};
  flow.options.sound_speed = 30;
  flow.options.body_force.gravity = {0, -9.81};
  flow.options.viscosity = Viscosity::artificial;
  flow.options.diffusion = DensityDiffusion::antuono;
  flow.options.shifting = 0.5;
  flow.pressure = [](const Place& at) { return 9.81 * (0.6 - at[1]); };
  with_wall(flow, 0, false, {.slips = true});
  with_wall(flow, 0, true);
  with_wall(flow, 1, false, {.velocity = [](double t) { return Triple{0.5 * std::sin(20 * t)}; }});
  return flow;
}

void make_periodic(FlowCase& flow) {
  flow.plan.walls.erase(flow.plan.walls.begin(), flow.plan.walls.begin() + 2);
  flow.plan.periodic[0] = true;
}

/// With walls that drag alone, so that shifting keeps the volume.
void lose_free_surface(FlowCase& flow) {
  flow.options.free_surface = false;
  for (SideWall& wall : flow.plan.walls) wall.body.travels = false;
}

/// With nothing that needs all neighbours of a particle.
void use_pairs_alone(FlowCase& flow) {
  flow.options.diffusion = DensityDiffusion::fourtakas;
  flow.options.shifting = 0;
}

struct Way {
  const char* name;
  std::function<void(FlowCase&)> choose;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

/// Ways to run that take different paths through the model.
const std::vector<Way> ways{
    {"antuono", [](FlowCase&) {}},
    {"dynamic_walls", [](FlowCase& flow) { flow.options.walls = WallForm::dynamic; }},
    {"tait", [](FlowCase& flow) { flow.options.equation_of_state = StateEquation::tait; }},
    {"summation", [](FlowCase& flow) { flow.options.density_form = FluidDensity::summation; }},
    {"operator",
     [](FlowCase& flow) {
       flow.options.pressure = flow.options.divergence = Derivatives::by_operator;
       flow.options.shifting = 0;
     }},
    {"kd_tree", [](FlowCase& flow) { flow.search = "kd_tree"; }},
    {"periodic", make_periodic},
    {"no_free_surface", lose_free_surface},
    {"pairs_alone", use_pairs_alone},
    {"pairs_alone_periodic", [](FlowCase& flow) {
       make_periodic(flow);
       use_pairs_alone(flow);
     }}};

constexpr double step = 1e-4;

std::vector<double> state_after(const FlowCase& given, int threads, int steps) {
  omp_set_num_threads(threads);
  const auto flow = make_flow<2>(given);
  run(*flow, steps * step, steps);
  omp_set_num_threads(2);
  return state_by_id(*flow);
}

struct FlowOneWay : testing::TestWithParam<Way> {
  FlowCase given(double spacing) const {
    FlowCase flow = busy_tank(spacing);
    GetParam().choose(flow);
    return flow;
  }
};

/// Enough particles for loops to be shared.
TEST_P(FlowOneWay, HasTheSameBitsForAnyNumberOfThreads) {
  const FlowCase flow = given(0.01);
  const std::vector<double> one = state_after(flow, 1, 6);
  EXPECT_GT(one.size(), std::size_t{7} * parallel_from);
  EXPECT_TRUE(one == state_after(flow, 2, 6));
  EXPECT_TRUE(one == state_after(flow, 4, 6));
  EXPECT_FALSE(one == state_after(flow, 2, 5));  // the negative control
}

/// Two stretches with a snapshot between them, or the second one from the snapshot alone.
TEST_P(FlowOneWay, HasTheSameBitsAfterARestart) {
  const FlowCase flow = given(0.04);
  const auto whole = make_flow<2>(flow), resumed = make_flow<2>(flow);
  run(*whole, 20 * step, 20);
  whole->complete_fields();
  const Cloud snapshot = whole->cloud();
  run(*whole, 40 * step, 20, 20 * step);
  resumed->restore(snapshot);
  run(*resumed, 40 * step, 20, 20 * step);
  EXPECT_TRUE(state_by_id(*whole) == state_by_id(*resumed));
  resumed->restore(snapshot);
  run(*resumed, 39 * step, 19, 20 * step);
  EXPECT_FALSE(state_by_id(*whole) == state_by_id(*resumed));  // the negative control
}

/// Memory that steps ask for after the first ones, in which lists reach their length.
long allocations_in_steps(const FlowCase& given) {
  const auto flow = make_flow<2>(given);
  VelocityVerlet integrator;
  flow->start_afresh();
  for (int k = 0; k < 20; ++k) step_once(*flow, integrator, k * step, step);
  const long before = allocations();
  for (int k = 20; k < 60; ++k) step_once(*flow, integrator, k * step, step);
  return allocations() - before;
}

TEST_P(FlowOneWay, AllocatesNothingInItsSteps) {
  if (std::string(GetParam().name) == "kd_tree") GTEST_SKIP() << "a tree is grown anew each time";
  EXPECT_EQ(allocations_in_steps(given(0.02)), 0);
}

INSTANTIATE_TEST_SUITE_P(, FlowOneWay, testing::ValuesIn(ways),
                         [](const auto& way) { return std::string(way.param.name); });

/// Particles stand in the order of the search, so both searches list them alike. Rows that reach
/// further, the negative control, add up in other packs and agree but for rounding.
struct Searches : testing::TestWithParam<void (*)(FlowCase&)> {};

TEST_P(Searches, AgreeToTheLastBit) {
  FlowCase flow = busy_tank(0.02);
  GetParam()(flow);
  flow.search = "cell_grid";
  const std::vector<double> grid = state_after(flow, 2, 20);
  flow.search = "kd_tree";
  EXPECT_EQ(state_after(flow, 2, 20), grid);
  flow.skin = 0.15;
  const std::vector<double> wide = state_after(flow, 2, 20);
  double scale = 0, apart = 0;
  ASSERT_EQ(grid.size(), wide.size());
  for (std::size_t k = 0; k < grid.size(); ++k) {
    scale = std::max(scale, std::abs(grid[k]));
    apart = std::max(apart, std::abs(grid[k] - wide[k]));
  }
  EXPECT_LT(apart, 1e-12 * scale);
  EXPECT_GT(apart, 0);
}

INSTANTIATE_TEST_SUITE_P(, Searches,
                         testing::Values([](FlowCase&) {}, use_pairs_alone,
                                         [](FlowCase& flow) {
                                           make_periodic(flow);
                                           use_pairs_alone(flow);
                                         }));

/// A block of fluid at rest on its own.
FlowCase block() { return flow_in_a_box(2, 0.05, {0.5, 0.5}); }

constexpr double length = 1.5 * 0.05;  // smoothing length of the block

double longest_step(const FlowCase& flow, double courant) {
  return make_flow<2>(flow)->longest_step(0, courant);
}

TEST(LongestStep, IsThatOfSound) {
  FlowCase flow = block();
  EXPECT_DOUBLE_EQ(longest_step(flow, 0.3), 0.3 * length / 10);
  flow.velocity = [](const Place&) { return Triple{3, 4}; };
  EXPECT_DOUBLE_EQ(longest_step(flow, 0.3), 0.3 * length / (10 + 5));
}

TEST(LongestStep, IsThatOfForces) {
  FlowCase flow = block();
  flow.options.body_force.gravity = {0, -1e5};
  flow.options.diffusion = DensityDiffusion::none;
  EXPECT_NEAR(longest_step(flow, 0.3), 0.3 * std::sqrt(length / 1e5), 1e-15);
}

TEST(LongestStep, IsThatOfViscosity) {
  FlowCase flow = block();
  flow.options.viscosity = Viscosity::morris;
  flow.options.kinematic_viscosity = 100;
  EXPECT_DOUBLE_EQ(longest_step(flow, 0.3), 0.125 * length * length / 100);
}

TEST(Warnings, TellWhereParticlesLeft) {
  FlowCase flow = block();
  flow.velocity = [](const Place&) { return Triple{0, -1}; };
  const auto made = make_flow<2>(flow);
  run(*made, 0.15, 300);
  EXPECT_THAT(made->warnings(), IsEmpty());
  // The first row, of ten particles 0.025 above the side, is gone when it is 0.15, the reach of the
  // kernel, below it, and the next one after another spacing.
  run(*made, 0.2, 100, 0.15);
  EXPECT_EQ(told(*made, "removed"), 10);
  EXPECT_THAT(made->warnings(),
              ElementsAre(AllOf(HasSubstr("10 particles left the domain and were removed, first "
                                          "particle "),
                                HasSubstr(", -0.15"), HasSubstr("through y_lower, t = 0.17"))));
  EXPECT_EQ(made->cloud().count(), 90);
}

TEST(Warnings, TellOfASoundSpeedThatIsTooLow) {
  FlowCase flow = block();
  flow.velocity = [](const Place&) { return Triple{2}; };
  const auto slow = make_flow<2>(flow);
  update_rates(*slow);
  EXPECT_THAT(slow->warnings(),
              ElementsAre(HasSubstr("the sound speed 10 is less than ten times the highest speed, "
                                    "2 at t = 0")));
  flow.options.sound_speed = 20;
  const auto fast = make_flow<2>(flow);
  update_rates(*fast);
  EXPECT_THAT(fast->warnings(), IsEmpty());
}

}  // namespace
}  // namespace mote::test
