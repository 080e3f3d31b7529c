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

/// One step: how long it takes, in seconds, and how far it goes.
struct TrialStep {
  double seconds = std::numeric_limits<double>::infinity(), length = 0;
};

/// The quickest of the first few steps or of half a second of them; nothing of them is kept.
TrialStep trial_step(Simulation& simulation) {
  TrialStep best;
  double total = 0;
  for (int repeat = 0; repeat < 5 && total < 0.5; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    const double length = simulation.advance(0, simulation.next_step(1, 1, 0).length);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    best = {std::min(best.seconds, took.count()), length};
    total += took.count();
  }
  return best;
}

/// Steps of the run; if the state or the integrator decides on them, as many as there are while
/// they stay like the first.
std::int64_t expected_steps(Simulation& simulation, const TrialStep& step) {
  if (!simulation.has_steps_of_its_own()) return simulation.plan().total_steps();
  return std::llround(simulation.scenario().time.end / step.length);
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
  const TrialStep step = trial_step(simulation);
  const std::int64_t steps = expected_steps(simulation, step);
  const TimePlan& plan = simulation.plan();
  const double frame_bytes = 2.0 * static_cast<double>(bytes_of_fields(simulation.model().cloud()));
  fmt::print("{}", simulation.resolved_yaml());
  for (const auto& warning : simulation.warnings()) fmt::print(stderr, "{}\n", warning);
  fmt::print("# valid: {} particles, {}{} steps, {} snapshots\n",
             simulation.model().cloud().count(), simulation.has_steps_of_its_own() ? "about " : "",
             steps, plan.frames() + 1);
  fmt::print("# memory: about {:.3g} MB; disk: about {:.3g} MB\n", 1e-6 * memory,
             1e-6 * frame_bytes * static_cast<double>(plan.frames() + 1));
  fmt::print("# time: about {:.3g} s, by its first steps\n",
             step.seconds * static_cast<double>(steps));
  return 0;
}

}  // namespace mote
