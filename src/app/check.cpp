#include <fmt/format.h>

#include <chrono>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// Seconds of one step from the initial state, the shortest of a few; the state is not kept.
double seconds_a_step(Simulation& simulation) {
  double shortest = 1e300;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    simulation.model().prepare(0);
    simulation.model().update_kick_rates(0);
    simulation.model().update_drift_rates(0);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, took.count());
  }
  return shortest;
}

std::size_t bytes_of_fields(const Cloud& cloud) {
  std::size_t bytes = 0;
  for (const Field& field : cloud.fields()) bytes += field.values.size() * sizeof(double);
  return bytes;
}

}  // namespace

int check(const Catalogue& catalogue, const RunOptions& options) {
  Simulation simulation = prepare_simulation(catalogue, options);
  const double seconds = seconds_a_step(simulation);
  const TimePlan& plan = simulation.plan();
  const auto steps = static_cast<double>(plan.total_steps());
  const double frame_bytes = 2.0 * static_cast<double>(bytes_of_fields(simulation.model().cloud()));
  fmt::print("{}", simulation.resolved_yaml());
  for (const auto& warning : simulation.warnings()) fmt::print(stderr, "{}\n", warning);
  fmt::print("# valid: {} particles, {} steps, {} snapshots\n", simulation.model().cloud().count(),
             plan.total_steps(), plan.frames() + 1);
  fmt::print("# memory: about {:.3g} MB; disk: about {:.3g} MB\n",
             400e-6 * simulation.model().cloud().count(),
             1e-6 * frame_bytes * static_cast<double>(plan.frames() + 1));
  fmt::print("# time: {:.3g} s for {:.3g} evaluations of the rates, one measured\n",
             seconds * steps, steps);
  return 0;
}

}  // namespace mote
