#include "mote/integrators/stoermer_13.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mote/integrators/bulirsch_stoer.hpp"
#include "mote/integrators/free_fall.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

namespace {

constexpr std::size_t history = 12;  // accelerations that a step depends on
constexpr double starting_tolerance = 1e-15;

using Series = std::vector<long double>;

Series product(const Series& a, const Series& b) {
  Series result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; i + j < a.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

/// 1/a for a series that begins with 1.
Series reciprocal(const Series& a) {
  Series result(a.size());
  result[0] = 1;
  for (std::size_t n = 1; n < a.size(); ++n)
    for (std::size_t k = 1; k <= n; ++k) result[n] -= a[k] * result[n - k];
  return result;
}

const MultistepCoefficients& coefficients() {
  static const MultistepCoefficients known = multistep_coefficients(history + 2);
  return known;
}

/// sum_j=first..last coefficient_j nabla^(j - first) f, from the highest to the lowest difference.
Row weighted_sum(const std::vector<Row>& difference, const std::vector<double>& coefficient,
                 std::size_t first, std::size_t last) {
  Row sum(difference[0].size());
  for (std::size_t j = last + 1; j-- > first;)
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += coefficient[j] * difference[j - first][i];
  return sum;
}

/// row/unit - correction.
Row without(const Row& row, double unit, const Row& correction) {
  Row result(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) result[i] = row[i] / unit - correction[i];
  return result;
}

}  // namespace

MultistepCoefficients multistep_coefficients(int count) {
  Series logarithm(count);
  for (int n = 0; n < count; ++n) logarithm[n] = 1 / static_cast<long double>(n + 1);
  const Series gamma = reciprocal(logarithm), cowell = product(gamma, gamma);
  const Series sigma = product(cowell, Series(count, 1));
  return {
      {gamma.begin(), gamma.end()}, {sigma.begin(), sigma.end()}, {cowell.begin(), cowell.end()}};
}

/// The error of an addition is a number too, and this is it (Knuth 1969).
void LongRowSum::add(const Row& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double sum = sum_[i] + row[i], added = sum - sum_[i];
    lost_[i] += (sum_[i] - (sum - added)) + (row[i] - added);
    sum_[i] = sum;
  }
}

void LongRowSum::add(const LongRowSum& other) {
  add(other.sum_);
  for (std::size_t i = 0; i < lost_.size(); ++i) lost_[i] += other.lost_[i];
}

Row LongRowSum::times(double factor, const Row& correction) const {
  Row row(sum_.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    row[i] = factor * (sum_[i] + (lost_[i] + correction[i]));
  return row;
}

Row LongRowSum::memory() const {
  Row row = sum_;
  append(row, lost_);
  return row;
}

void LongRowSum::recall(Row sum, Row lost) {
  sum_ = std::move(sum);
  lost_ = std::move(lost);
}

std::string Stoermer13::missing_in(System& system) const { return missing_for_free_fall(system); }

void Stoermer13::advance_one_step(System& system, double time, double step) {
  if (!goes_on(time, step)) begin(system, time, step);
  if (difference_.size() < history)
    take_starting_step(system, time);
  else
    take_summed_step(system, time);
}

bool Stoermer13::goes_on(double time, double step) const {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  return !difference_.empty() &&
         std::abs(step - step_) <= rounding * (std::abs(time) + std::abs(step));
}

void Stoermer13::begin(System& system, double time, double step) {
  step_ = step;
  difference_ = {falling_state(system, time).acceleration};
}

/// With a starter that knows nothing of the steps before, so that it has no memory.
void Stoermer13::take_starting_step(System& system, double time) {
  BulirschStoer starter;
  starter.tolerate(starting_tolerance);
  for (double gone = 0; gone < step_;) gone += starter.advance(system, time + gone, step_ - gone);
  add_acceleration(system, time + step_);
  if (difference_.size() == history) begin_sums(system);
}

/// Evaluates the accelerations at the new places, and forms their differences.
void Stoermer13::add_acceleration(System& system, double time) {
  system.prepare(time);
  system.update_kick_rates(time);
  Row newest = in_a_row(system.kicked(), &Evolving::rate);
  for (Row& difference : difference_) {
    Row next = newest;
    for (std::size_t i = 0; i < next.size(); ++i) next[i] -= difference[i];
    difference = std::exchange(newest, std::move(next));
  }
  if (difference_.size() < history) difference_.push_back(std::move(newest));
}

/// The sums that belong to place and velocity now: F_n by the formula for v_n, and S_n-1 by
/// Cowell's x_n = h^2 (S_n-1 + sum_j=2..13 cowell_j nabla^(j-2) f_n).
void Stoermer13::begin_sums(System& system) {
  const auto& [gamma, sigma, cowell] = coefficients();
  const Row place = in_a_row(system.drifted(), &Evolving::value);
  const Row velocity = in_a_row(system.kicked(), &Evolving::value);
  first_ = LongRowSum(without(velocity, step_, weighted_sum(difference_, gamma, 1, history)));
  second_ =
      LongRowSum(without(place, step_ * step_, weighted_sum(difference_, cowell, 2, history + 1)));
  second_.add(first_);
}

void Stoermer13::take_summed_step(System& system, double time) {
  const auto& [gamma, sigma, cowell] = coefficients();
  spread(second_.times(step_ * step_, weighted_sum(difference_, sigma, 2, history)),
         system.drifted());
  add_acceleration(system, time + step_);
  first_.add(difference_[0]);
  second_.add(first_);
  spread(first_.times(step_, weighted_sum(difference_, gamma, 1, history)), system.kicked());
}

std::vector<double> Stoermer13::memory() const {
  if (difference_.empty()) return {};
  std::vector<double> memory{step_, static_cast<double>(difference_.size())};
  for (const Row& row : difference_) append(memory, row);
  if (difference_.size() < history) return memory;
  append(memory, first_.memory());
  append(memory, second_.memory());
  return memory;
}

void Stoermer13::recall(std::span<const double> memory) {
  difference_.clear();
  if (memory.empty()) return;
  const std::size_t head = 2;
  const std::size_t count = memory.size() > head ? static_cast<std::size_t>(memory[1]) : 0;
  const std::size_t rows = count == history ? history + 4 : count;
  if (count < 1 || count > history || (memory.size() - head) % rows != 0)
    throw InputError("what the snapshot keeps for the integrator is not of stoermer_13");
  const std::size_t size = (memory.size() - head) / rows;
  step_ = memory[0];
  memory = memory.subspan(head);
  for (std::size_t k = 0; k < count; ++k) difference_.push_back(take_front(memory, size));
  if (count < history) return;
  for (LongRowSum* sum : {&first_, &second_}) {
    Row high = take_front(memory, size);
    sum->recall(std::move(high), take_front(memory, size));
  }
}

}  // namespace mote
