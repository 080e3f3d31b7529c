#include "mote/integrators/embedded_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/integrators/initial_step.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

[[noreturn]] void fail_for_rates() {
  throw NumericalFailure("rates of change are not finite numbers", {},
                         "values have grown beyond bounds, or particles have met");
}

}  // namespace

double EmbeddedPair::advance(System& system, double time, double longest) {
  start_or_fail(system, time);
  if (proposed_ == 0) proposed_ = initial_step(system, time, tolerance_, power_);
  const double first = std::min(proposed_, longest);
  double step = first, error = 0;
  while (true) {
    if (step < longest && time + step / 10 == time) fail(step, error);
    error = try_step(system, time, step) / tolerance_;
    if (error <= 1) break;
    step = control_.after_rejected(step, error);
  }
  finish(system, step);
  const bool rejected = step < first;
  // A step cut short for its caller's sake says nothing about the next one.
  if (longest < proposed_ && !rejected) return step;
  const double next = control_.after_accepted(step, error);
  proposed_ = rejected ? std::min(next, step) : next;
  return step;
}

void EmbeddedPair::advance_one_step(System& system, double time, double step) {
  start_or_fail(system, time);
  if (!std::isfinite(try_step(system, time, step))) fail_for_rates();
  finish(system, step);
}

std::vector<double> EmbeddedPair::memory() const {
  if (proposed_ == 0) return {};
  return {proposed_, control_.previous_error()};
}

void EmbeddedPair::recall(std::span<const double> memory) {
  if (memory.empty()) {
    proposed_ = 0;
    control_ = StepControl(power_);
  } else {
    proposed_ = memory[0];
    control_.recall(memory[1]);
  }
}

void EmbeddedPair::start_or_fail(System& system, double time) {
  if (!start(system, time)) fail_for_rates();
}

void EmbeddedPair::fail(double step, double error) const {
  throw NumericalFailure(
      fmt::format("{} found no step that keeps to the tolerance of {:.1e}, down to {:.1e}", name_,
                  tolerance_, step),
      {},
      std::isfinite(error) ? "accelerations grow without bound here, rates jump, or the tolerance "
                             "asks for more digits than numbers have"
                           : "rates of change are not finite numbers after any step");
}

}  // namespace mote
