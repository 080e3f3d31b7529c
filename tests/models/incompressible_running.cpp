// How an incompressible flow runs: the same bits for any number of threads and after a restart.

#include <gmock/gmock.h>
#include <omp.h>

#include "support/incompressible_case.hpp"

namespace mote::test {
namespace {

/// Water that falls in a tank with a shaking wall, with all that a flow can do.
IncompressibleCase falling_water(double spacing) {
  auto flow = incompressible_box<2>(spacing, {0.8, 0.64});
  flow.plan.upper = {1.2, 1.2};
  flow.options.body_force.gravity = {0, -9.81};
  flow.options.kinematic_viscosity = 1e-4;
  flow.options.shifting = 0.5;
  flow.options.collision_distance = 0.5;
  with_wall(flow, 0, false, {.slips = true});
  with_wall(flow, 0, true);
  return with_wall(flow, 1, false,
                   {.velocity = [](double t) { return Triple{0.5 * std::sin(20 * t)}; }});
}

/// Vortices in a box without a surface.
IncompressibleCase vortices(double spacing) {
  auto flow = incompressible_box<2>(spacing, {0.8, 0.8}, {true, false, false});
  flow.options.kinematic_viscosity = 1e-3;
  flow.options.shifting = 1;
  flow.velocity = [](const Place& at) {
    return Triple{std::sin(8 * at[0]) * std::cos(8 * at[1]),
                  -std::cos(8 * at[0]) * std::sin(8 * at[1])};
  };
  return in_disorder(without_surface(with_walls(flow)));
}

struct Way {
  const char* name;
  std::function<IncompressibleCase(double)> make;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

/// Ways to run that take different paths through the model.
const std::vector<Way> ways{{"free_surface", falling_water},
                            {"closed", vortices},
                            {"mps_pressure",
                             [](double spacing) {
                               auto flow = falling_water(spacing);
                               flow.options.laplacian = PressureLaplacian::mps;
                               flow.options.tension = false;
                               return flow;
                             }},
                            {"density_source",
                             [](double spacing) {
                               auto flow = vortices(spacing);
                               flow.options.source = PressureSource::density;
                               return flow;
                             }},
                            {"missing_neighbours",
                             [](double spacing) {
                               auto flow = falling_water(spacing);
                               flow.options.surface_test = SurfaceTest::missing_neighbours;
                               flow.options.gradient = PressureGradient::repulsive;
                               return with_operator(flow, symmetric_mps<2>());
                             }},
                            {"eigen", [](double spacing) {
                               auto flow = vortices(spacing);
                               flow.options.solver = "eigen";
                               return flow;
                             }}};

constexpr double step = 2e-3;

std::vector<double> state_after(const IncompressibleCase& given, int threads, int steps) {
  omp_set_num_threads(threads);
  const auto flow = make_incompressible<2>(given);
  take_steps(*flow, steps, step);
  omp_set_num_threads(2);
  return state_by_id(*flow);
}

struct IncompressibleOneWay : testing::TestWithParam<Way> {};

/// Enough particles for loops to be shared.
TEST_P(IncompressibleOneWay, HasTheSameBitsForAnyNumberOfThreads) {
  const auto flow = GetParam().make(0.01);
  const std::vector<double> one = state_after(flow, 1, 4);
  EXPECT_GT(one.size(), std::size_t{7} * parallel_from);
  EXPECT_TRUE(one == state_after(flow, 2, 4));
  EXPECT_TRUE(one == state_after(flow, 4, 4));
  EXPECT_FALSE(one == state_after(flow, 2, 3));  // the negative control
}

/// How often neighbours were found anew, by the report.
int searches_of(const Model& flow) {
  const std::string report = flow.remarks().front(), word = "found anew ";
  return std::stoi(report.substr(report.find(word) + word.size()));
}

/// Two stretches with a snapshot between them, or the second one from the snapshot alone; in both
/// neighbours are found anew on the way.
TEST_P(IncompressibleOneWay, HasTheSameBitsAfterARestart) {
  auto given = GetParam().make(0.04);
  given.skin = 0.02;
  const auto whole = make_incompressible<2>(given), resumed = make_incompressible<2>(given);
  take_steps(*whole, 20, step);
  whole->complete_snapshot();
  const Cloud snapshot = whole->cloud();
  take_steps(*whole, 20, step, 20 * step);
  resumed->restore(snapshot);
  take_steps(*resumed, 20, step, 20 * step);
  EXPECT_GT(searches_of(*resumed), 1 + 1 + 2);  // the start, the restart, and on the way
  EXPECT_TRUE(state_by_id(*whole) == state_by_id(*resumed));
  resumed->restore(snapshot);
  take_steps(*resumed, 19, step, 20 * step);
  EXPECT_FALSE(state_by_id(*whole) == state_by_id(*resumed));  // the negative control
}

INSTANTIATE_TEST_SUITE_P(, IncompressibleOneWay, testing::ValuesIn(ways),
                         [](const auto& way) { return std::string(way.param.name); });

}  // namespace
}  // namespace mote::test
