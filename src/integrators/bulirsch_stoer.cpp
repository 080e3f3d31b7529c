#include "mote/integrators/bulirsch_stoer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/integrators/free_fall.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

namespace {

constexpr int fewest_results = 3;

/// Steps of the k-th result.
constexpr int steps_of(int k) { return 2 * k; }

/// Evaluations for k results, with the one at the start.
constexpr double cost(int k) { return 1 + k * (k + 1); }

double largest(std::span<const double> row) {
  double value = 0;
  for (const double number : row) value = std::max(value, std::abs(number));
  return value;
}

/// Parts that change by what is in a row.
std::vector<Evolving> changing(std::span<const Evolving> parts, std::span<const double> change) {
  std::vector<Evolving> changing;
  for (const Evolving& part : parts) {
    changing.push_back({part.value, change.first(part.value.size())});
    change = change.subspan(part.value.size());
  }
  return changing;
}

/// By what to multiply the step for an error (in tolerances) of the last but one of k results to
/// become 0.65, with a little to spare (Hairer, Norsett & Wanner 1993, (II.9.23), and the bounds of
/// their code).
double change_of_step(double error, int k) {
  const double exponent = 1.0 / (2 * k - 1), least = std::pow(0.02, exponent);
  return std::clamp(0.94 * std::pow(0.65 / error, exponent), least / 4, 1 / least);
}

/// An error after k results that as many as expected, and one more, will not bring below 1, if each
/// divides it by (n_i/n_1)^2 (the same, (II.9.29) and (II.9.30)).
double hopeless_error(int k, int expected) {
  double error = 1;
  for (int i = k + 1; i <= expected + 1; ++i)
    error *= std::pow(static_cast<double>(steps_of(i)) / steps_of(1), 2);
  return error;
}

}  // namespace

std::string BulirschStoer::missing_in(System& system) const {
  return missing_for_free_fall(system);
}

void BulirschStoer::tolerate(double error) {
  if (!(error > 0)) throw InputError("the error that a step may make must be above 0");
  tolerance_ = error;
}

void BulirschStoer::begin(double step) {
  step_ = step;
  results_.clear();
  changes_ = {};
  path_.reset();
}

void BulirschStoer::add_result(System& system) {
  const int steps = steps_of(static_cast<int>(results_.size()) + 1);
  results_.push_back(stoermer_rule(system, start_, step_, steps));
  changes_.add(steps, results_.back().change);
}

/// Puts the system at the end of the step.
void BulirschStoer::finish(System& system) {
  const std::span<const double> change = changes_.best();
  const std::size_t size = start_.place.size();
  spread(start_.place, system.drifted());
  drift(system, changing(system.drifted(), change.first(size)), 1);
  kick(system, changing(system.kicked(), change.last(size)), 1);
  end_ = {start_.time + step_,
          in_a_row(system.drifted(), &Evolving::value),
          in_a_row(system.kicked(), &Evolving::value),
          {}};
}

void BulirschStoer::advance_one_step(System& system, double time, double step) {
  start_ = falling_state(system, time);
  begin(step);
  for (int k = 1; 2 * k <= order; ++k) add_result(system);
  finish(system);
}

double BulirschStoer::advance(System& system, double time, double longest) {
  start_ = falling_state(system, time);
  if (!proposal_) proposal_ = first_proposal();
  const bool cut_short = longest < proposal_->step;
  Proposal tried{std::min(longest, proposal_->step), proposal_->results};
  bool at_once = true;
  while (true) {
    if (!(time + tried.step > time))
      throw NumericalFailure(
          "the step has become too short to change the time", {},
          "bodies collide, or the tolerance is finer than the rounding of the accelerations");
    if (converges(system, tried)) break;
    tried = after_failure(tried);
    at_once = false;
  }
  if (!cut_short || !at_once) proposal_ = after_success(at_once);
  finish(system);
  return tried.step;
}

/// A tenth of the shortest time in which the largest values change by themselves; where nothing
/// moves or is moved, any length serves. The number of results as in the code ODEX.
BulirschStoer::Proposal BulirschStoer::first_proposal() const {
  const double place = largest(start_.place), velocity = largest(start_.velocity),
               acceleration = largest(start_.acceleration);
  double shortest = std::numeric_limits<double>::infinity();
  for (const double time :
       {place / velocity, std::sqrt(place / acceleration), velocity / acceleration})
    if (time > 0) shortest = std::min(shortest, time);
  const int results = static_cast<int>(1.5 - 0.6 * std::log10(tolerance_));
  return {std::isfinite(shortest) ? 0.1 * shortest : 1,
          std::clamp(results, fewest_results, most_results - 1)};
}

/// Whether the error falls below the tolerance with about as many results as expected.
bool BulirschStoer::converges(System& system, const Proposal& tried) {
  begin(tried.step);
  for (int k = 1; k <= tried.results + 1; ++k) {
    add_result(system);
    if (k == 1) continue;
    const double found = error(system);
    length_[k] = step_ * change_of_step(found, k);
    work_[k] = cost(k) / length_[k];
    if (k < tried.results - 1) continue;
    if (found <= 1) return true;
    if (found > hopeless_error(k, tried.results)) return false;
  }
  return false;
}

/// The largest error of the second best result, in tolerances times the largest value of its part.
double BulirschStoer::error(System& system) const {
  const std::span<const double> best = changes_.best(), second = changes_.second_best();
  Row start = start_.place;
  append(start, start_.velocity);
  std::size_t i = 0;
  double worst = 0;
  for (const auto parts : {system.drifted(), system.kicked()})
    for (const Evolving& part : parts) {
      double scale = 0, difference = 0;
      for (const std::size_t end = i + part.value.size(); i < end; ++i) {
        if (!std::isfinite(best[i])) return std::numeric_limits<double>::infinity();
        scale = std::max({scale, std::abs(start[i]), std::abs(start[i] + best[i])});
        difference = std::max(difference, std::abs(best[i] - second[i]));
      }
      if (difference > 0) worst = std::max(worst, difference / (tolerance_ * scale));
    }
  return worst;
}

/// The shorter step after a try that failed.
BulirschStoer::Proposal BulirschStoer::after_failure(const Proposal& tried) const {
  int k = std::min(tried.results, static_cast<int>(results_.size()));
  if (k > fewest_results && work_[k - 1] < 0.8 * work_[k]) --k;
  return {std::min(length_[k], 0.7 * tried.step), std::max(k, fewest_results)};
}

/// The step after one that succeeded, `at_once` or with a shorter step than first tried: with the
/// number of results that takes the fewest evaluations by time (Hairer, Norsett & Wanner 1993,
/// (II.9.27) and (II.9.28)).
BulirschStoer::Proposal BulirschStoer::after_success(bool at_once) const {
  const int k = static_cast<int>(results_.size());
  int next = k;
  if (k > 2 && work_[k - 1] < 0.8 * work_[k])
    --next;
  else if (at_once && (k == 2 || work_[k] < 0.9 * work_[k - 1]))
    ++next;
  next = std::clamp(next, fewest_results, most_results - 1);
  const double length = next <= k ? length_[next] : length_[k] * cost(next) / cost(k);
  return {at_once ? length : std::min(length, step_), next};
}

void BulirschStoer::go_along_path(System& system, double part) {
  if (!path_) {
    spread(end_.place, system.drifted());
    system.prepare(end_.time);
    system.update_kick_rates(end_.time);
    end_.acceleration = in_a_row(system.kicked(), &Evolving::rate);
    path_.emplace(start_, end_, step_, results_);
  }
  const auto [place, velocity] = path_->at(part);
  spread(place, system.drifted());
  spread(velocity, system.kicked());
}

std::vector<double> BulirschStoer::memory() const {
  if (!proposal_) return {};
  return {proposal_->step, static_cast<double>(proposal_->results)};
}

void BulirschStoer::recall(std::span<const double> memory) {
  proposal_.reset();
  if (memory.empty()) return;
  if (memory.size() != 2)
    throw InputError("what the snapshot keeps for the integrator is not of bulirsch_stoer");
  proposal_ = {memory[0], static_cast<int>(memory[1])};
}

}  // namespace mote
