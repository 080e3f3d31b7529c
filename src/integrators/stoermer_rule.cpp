#include "mote/integrators/stoermer_rule.hpp"

#include <algorithm>
#include <cmath>

#include "mote/integrators/accumulator.hpp"
#include "mote/integrators/extrapolation.hpp"

namespace mote {

namespace {

/// a + factor b.
Row sum(const Row& a, double factor, std::span<const double> b) {
  Row row = a;
  for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * b[i];
  return row;
}

Row multiple(double factor, const Row& row) { return sum(Row(row.size()), factor, row); }

Row joined(Row places, std::span<const double> velocities) {
  append(places, velocities);
  return places;
}

Row acceleration_at(System& system, double time) {
  system.prepare(time);
  system.update_kick_rates(time);
  return in_a_row(system.kicked(), &Evolving::rate);
}

/// What values count for in their central difference of this order, from the leftmost on: for odd
/// orders the mean of the two differences beside the middle.
Row central_difference(int order) {
  Row weights{1};
  const auto refine = [&weights](double left, double middle, double right) {
    Row next(weights.size() + 2);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      next[i] += left * weights[i];
      next[i + 1] += middle * weights[i];
      next[i + 2] += right * weights[i];
    }
    weights = std::move(next);
  };
  for (int k = 0; k < order / 2; ++k) refine(1, -2, 1);
  if (order % 2 == 1) refine(-0.5, 0, 0.5);
  return weights;
}

/// This derivative of the accelerations in the middle of the step.
Row middle_derivative(std::span<const StoermerResult> results, int order, double step) {
  const Row weights = central_difference(order);
  const int reach = static_cast<int>(weights.size()) / 2;
  Extrapolation extrapolation;
  for (const StoermerResult& result : results) {
    const int middle = result.steps / 2;
    if (reach > middle) continue;
    Row difference(result.acceleration[0].size());
    for (std::size_t k = 0; k < weights.size(); ++k)
      difference = sum(difference, weights[k], result.acceleration[middle - reach + k]);
    extrapolation.add(result.steps, multiple(std::pow(result.steps / step, order), difference));
  }
  return extrapolation.best();
}

}  // namespace

FallingState falling_state(System& system, double time) {
  if (!system.rates_are_current()) {
    system.prepare(time);
    system.update_kick_rates(time);
  }
  return {time, in_a_row(system.drifted(), &Evolving::value),
          in_a_row(system.kicked(), &Evolving::value), in_a_row(system.kicked(), &Evolving::rate)};
}

/// Extrapolation multiplies what rounding does here by up to 100. So sums are of changes, not of
/// places, and keep what additions lose.
StoermerResult stoermer_rule(System& system, const FallingState& start, double step, int steps) {
  const double h = step / steps;
  StoermerResult result{steps, {}, {}, {start.acceleration}};
  Row place(start.place.size()), velocity = multiple(h / 2, start.acceleration);
  Accumulator drift, kick;
  for (int i = 1; i <= steps; ++i) {
    const Row speed = sum(start.velocity, 1, velocity);
    const Evolving drifting{place, speed};
    drift.advance({&drifting, 1}, h);
    spread(sum(start.place, 1, place), system.drifted());
    const Row acceleration =
        acceleration_at(system, i < steps ? start.time + i * h : start.time + step);
    const Row now = sum(velocity, h / 2, acceleration);
    if (2 * i == steps) result.middle_change = joined(place, now);
    if (i == steps) result.change = joined(place, now);
    const Evolving kicking{velocity, acceleration};
    kick.advance({&kicking, 1}, h);
    result.acceleration.push_back(acceleration);
  }
  return result;
}

ExtrapolatedPath::ExtrapolatedPath(const FallingState& start, const FallingState& end, double step,
                                   std::span<const StoermerResult> results) {
  Extrapolation middle;
  for (const StoermerResult& result : results) middle.add(result.steps, result.middle_change);
  const std::span<const double> change = middle.best();
  const std::size_t size = start.place.size();
  KnownNode node{
      step / 2,
      {sum(start.place, 1, change.first(size)), sum(start.velocity, 1, change.last(size))}};
  const int highest = std::max(0, 2 * static_cast<int>(results.size()) - 5);
  for (int order = 0; order <= highest; ++order)
    node.derivative.push_back(middle_derivative(results, order, step));
  nodes_ = {{0, {start.place, start.velocity, start.acceleration}},
            std::move(node),
            {step, {end.place, end.velocity, end.acceleration}}};
}

Interpolated ExtrapolatedPath::at(double part) const {
  return interpolate(nodes_, part * nodes_.back().time);
}

}  // namespace mote
