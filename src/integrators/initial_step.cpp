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
double time_of_change(std::span<const Evolving> parts) {
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

/// From the values and rates that the system has; where all is zero there is nothing to go by.
double time_of_change(System& system) {
  double time = std::min(time_of_change(system.drifted()), time_of_change(system.kicked()));
  if (time == unknown) time = time_from_rest(system);
  return time == unknown ? 1e-4 : time;
}

/// The largest |rate at stage 1 - rate at stage 0| of a part, over the largest of its values at the
/// start or of what they would gain in `time`; the largest of all parts that have either.
double relative_change(HalfStages& half, double time) {
  std::vector<double> scale;
  for (const Evolving& part : half.combined(std::array{1.0, 0.0}))
    scale.push_back(std::max(largest_magnitude(half.values_at_start().values(scale.size())),
                             time * largest_magnitude(part.rate)));
  const auto changes = half.combined(std::array{-1.0, 1.0});
  double largest = 0;
  for (std::size_t part = 0; part < changes.size(); ++part)
    if (scale[part] > 0)
      largest = std::max(largest, largest_magnitude(changes[part].rate) / scale[part]);
  return largest;
}

}  // namespace

double initial_step(System& system, double time, double tolerance, int power) {
  Stages stages;
  stages.start(system, 2);
  stages.evaluate(system, time, 0);
  const double first = time_of_change(system);
  const double probe = first / 100;
  stages.go_to(std::array{1.0, 0.0}, probe);
  stages.evaluate(system, time + probe, 1);
  stages.return_to_start();
  const double change =
      std::max(relative_change(stages.drifted, first), relative_change(stages.kicked, first));
  const double second = std::sqrt(probe / change);
  return std::min(first, second) * std::pow(tolerance / 100, 1.0 / power);
}

}  // namespace mote
