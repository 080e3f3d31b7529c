#include "mote/integrators/initial_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mote/integrators/relative_error.hpp"
#include "mote/integrators/stages.hpp"

namespace mote {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The shortest time in which a part would change as much as its largest value.
double shortest_time(std::span<const Evolving> parts) {
  double shortest = unknown;
  for (const Evolving& part : parts) {
    const double value = largest_magnitude(part.value), rate = largest_magnitude(part.rate);
    if (value > 0 && rate > 0) shortest = std::min(shortest, value / rate);
  }
  return shortest;
}

/// The time in which what is at rest would fall as far as the largest place.
double time_from_rest(System& system) {
  double place = 0, acceleration = 0;
  for (const Evolving& part : system.drifted())
    place = std::max(place, largest_magnitude(part.value));
  for (const Evolving& part : system.kicked())
    acceleration = std::max(acceleration, largest_magnitude(part.rate));
  return place > 0 && acceleration > 0 ? std::sqrt(place / acceleration) : unknown;
}

/// A length for the step of Euler's; where every value is zero there is nothing to take it from.
double probing_step(System& system) {
  double time = std::min(shortest_time(system.drifted()), shortest_time(system.kicked()));
  if (time == unknown) time = time_from_rest(system);
  return time == unknown ? 1e-6 : time / 100;
}

}  // namespace

double initial_step(System& system, double time, double tolerance, int power) {
  Stages stages;
  stages.start(system, 2);
  stages.evaluate(system, time, 0);
  const double probe = probing_step(system);
  stages.go_to(std::array{1.0, 0.0}, probe);
  stages.evaluate(system, time + probe, 1);
  const double first = relative_error(stages, std::array{1.0, 0.0}, 1);
  const double second = relative_error(stages, std::array{-1.0, 1.0}, 1 / probe);
  stages.return_to_start();
  const double scale = std::min(1 / first, 1 / std::sqrt(second));
  return std::min(100 * probe, scale * std::pow(tolerance / 100, 1.0 / power));
}

}  // namespace mote
