#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/particles/failure.hpp"
#include "mote/stationary/stationary_file.hpp"

namespace mote {
namespace {

/// Seconds of one step, the shortest of the first few or of half a second; nothing of them is kept.
double seconds_a_step(Simulation& simulation) {
  double shortest = std::numeric_limits<double>::infinity(), total = 0;
  for (int repeat = 0; repeat < 5 && total < 0.5; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    simulation.advance(0, simulation.next_step(1, 1, 0).length);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, took.count());
    total += took.count();
  }
  return shortest;
}

/// Steps of the run; if the state decides on them, as many as there are while they stay like the
/// first.
std::int64_t expected_steps(Simulation& simulation) {
  if (!simulation.has_steps_of_its_own()) return simulation.plan().total_steps();
  return std::llround(simulation.scenario().time.end / simulation.next_step(1, 1, 0).length);
}

std::size_t bytes_of_fields(const Cloud& cloud) {
  std::size_t bytes = 0;
  for (const Field& field : cloud.fields()) bytes += field.values.size() * sizeof(double);
  return bytes;
}

int check_stationary(StationaryFile file) {
  fmt::print("{}# valid: {} nodes, {} states\n", resolved_yaml(file), file.nodes, file.states);
  return 0;
}

}  // namespace

int check(const Catalogue& catalogue, const RunOptions& options) {
  const Document document = read_document(options);
  if (is_stationary(document)) return check_stationary(read_stationary(document));
  Simulation simulation = prepare_simulation(catalogue, options);
  const double memory = simulation.bytes_needed();
  const std::int64_t steps = expected_steps(simulation);
  const double seconds = seconds_a_step(simulation);
  const TimePlan& plan = simulation.plan();
  const double frame_bytes = 2.0 * static_cast<double>(bytes_of_fields(simulation.model().cloud()));
  fmt::print("{}", simulation.resolved_yaml());
  for (const auto& warning : simulation.warnings()) fmt::print(stderr, "{}\n", warning);
  fmt::print("# valid: {} particles, {}{} steps, {} snapshots\n",
             simulation.model().cloud().count(), simulation.has_steps_of_its_own() ? "about " : "",
             steps, plan.frames() + 1);
  fmt::print("# memory: about {:.3g} MB; disk: about {:.3g} MB\n", 1e-6 * memory,
             1e-6 * frame_bytes * static_cast<double>(plan.frames() + 1));
  fmt::print("# time: about {:.3g} s, by its first steps\n", seconds * static_cast<double>(steps));
  return 0;
}

}  // namespace mote
