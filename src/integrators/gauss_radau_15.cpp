#include "mote/integrators/gauss_radau_15.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "mote/integrators/free_fall.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using namespace gauss_radau;

/// A step that should have been shorter than this part of it is taken again; none is longer than
/// the last one over it.
constexpr double quarter = 0.25;

/// sum_k row[k] of_node[k].
[[gnu::always_inline]] inline Pack sum(const Row& row, const std::array<Pack, nodes>& of_node) {
  Pack total = row[0] * of_node[0];
  for (std::size_t k = 1; k < nodes; ++k) total += row[k] * of_node[k];
  return total;
}

/// value += term for value - lost, keeping what rounding loses (Kahan 1965).
[[gnu::always_inline]] inline void add_term(Pack& value, Pack& lost, const Pack& term) {
  const Pack change = term - lost;
  const Pack total = value + change;
  lost = (total - value) - change;
  value = total;
}

/// What rounding loses of the product x y.
[[gnu::always_inline]] inline Pack lost_of_product(double x, const Pack& y, const Pack& product) {
  Pack lost;
  for (std::size_t k = 0; k < pack_size; ++k) lost[k] = std::fma(x, y[k], -product[k]);
  return lost;
}

/// What a prediction over `ratio` of the last step makes of the changes at its nodes.
Table extrapolation(double ratio) {
  Table made;
  for (std::size_t i = 0; i < nodes; ++i) {
    const double s = ratio * node[i];
    for (std::size_t k = 0; k < nodes; ++k) {
      double value = 0;
      for (std::size_t m = nodes; m-- > 0;) value = (value + power_at_end[m][k]) * s;
      made[i][k] = value;
    }
  }
  return made;
}

/// x = x_0 + t (v_0 + t (a_0/2 + sum_k place_k G_k)), v = v_0 + t (a_0 + sum_k velocity_k G_k).
struct PathWeights {
  Row place{}, velocity{};
};

PathWeights path_weights(double part) {
  PathWeights weights;
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t m = nodes; m-- > 0;) {
      const double degree = static_cast<double>(m + 1);
      weights.place[k] = (weights.place[k] + power[m][k] / ((degree + 1) * (degree + 2))) * part;
      weights.velocity[k] = (weights.velocity[k] + power[m][k] / (degree + 1)) * part;
    }
  return weights;
}

auto* numbers_of(auto& of_nodes) {
  using Number = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(of_nodes)>>,
                                    const double, double>;
  return reinterpret_cast<Number*>(of_nodes.data());
}

std::size_t size_of(std::span<const Evolving> parts) {
  std::size_t size = 0;
  for (const Evolving& part : parts) size += part.value.size();
  return size;
}

}  // namespace

std::string GaussRadau15::missing_in(System& system) const { return missing_for_free_fall(system); }

void GaussRadau15::advance_one_step(System& system, double time, double step) {
  start(system, time);
  predict(step);
  sweep_until_converged(system, time, step);
  accept(system, step);
}

double GaussRadau15::advance(System& system, double time, double longest) {
  constexpr int most_trials = 60;
  start(system, time);
  if (next_step_ == 0) next_step_ = first_step(longest);
  double step = std::min(next_step_, longest);
  const double part = std::pow(5040 * tolerance_, 1.0 / 7);
  for (int trial = 0; trial < most_trials; ++trial) {
    if (!(time + step > time)) break;
    predict(step);
    const bool converged = sweep_until_converged(system, time, step);
    const double wanted = converged ? part * time_of_change(step) : quarter * quarter * step;
    if (wanted < quarter * step) {
      step = wanted;
      continue;
    }
    accept(system, step);
    // The changes over a tiny step, one that was cut off, are little more than rounding.
    if (step > next_step_ / 100)
      next_step_ = std::min(wanted, std::max(step, next_step_) / quarter);
    return step;
  }
  throw NumericalFailure("the method gauss_radau_15 finds no step short enough", {},
                         "accelerations are not smooth, or two bodies meet");
}

/// Takes up the state and the acceleration there. Where it is not that which the last step left,
/// somebody has changed it, and what is known of the past does not hold.
void GaussRadau15::start(System& system, double time) {
  const std::size_t count = size_of(system.drifted());
  if (count != count_) resize(count);
  if (!place_.has_values(system.drifted()) || !velocity_.has_values(system.kicked())) {
    resize(count);
    place_.take_values(system.drifted());
    velocity_.take_values(system.kicked());
  }
  const auto dimension = static_cast<std::size_t>(system.dimension());
  dimension_ = dimension > 0 ? dimension : count;
  system.prepare(time);
  system.update_kick_rates(time);
  start_.take_rates(system.kicked());
}

void GaussRadau15::resize(std::size_t count) {
  count_ = count;
  last_step_ = next_step_ = predictions_ = 0;
  for (PackedColumn* column :
       {&place_, &velocity_, &lost_place_, &lost_velocity_, &start_place_, &start_velocity_,
        &start_, &rate_, &moved_, &jerk_, &snap_, &crackle_})
    column->resize(count);
  for (Nodes* of_nodes : {&change_, &predicted_, &next_, &foretold_})
    of_nodes->assign(place_.packs(), {});
}

/// A small part of the times |v|/|a| and sqrt(|x|/|a|) of every body.
double GaussRadau15::first_step(double longest) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < count_; first += dimension_) {
    const auto size = [&](const PackedColumn& column) {
      const double* numbers = column.begin() + first;
      return std::sqrt(std::inner_product(numbers, numbers + dimension_, numbers, 0.0));
    };
    const double x = size(place_), v = size(velocity_), a = size(start_);
    if (a > 0 && x > 0) shortest = std::min(shortest, std::sqrt(x / a));
    if (a > 0 && v > 0) shortest = std::min(shortest, v / a);
  }
  if (std::isfinite(shortest)) return 0.05 * shortest;
  return std::isfinite(longest) ? longest : 1;
}

/// The last step's polynomial goes on, with the correction that the last prediction needed.
void GaussRadau15::predict(double step) {
  if (predictions_ == 0) {
    next_.assign(next_.size(), {});
    foretold_ = next_;
    return;
  }
  const Table onward = extrapolation(step / last_step_);
  for (std::size_t p = 0; p < next_.size(); ++p)
    for (std::size_t i = 0; i < nodes; ++i) {
      foretold_[p][i] = next_[p][i] = sum(onward[i], change_[p]);
      if (predictions_ > 1) next_[p][i] += change_[p][i] - predicted_[p][i];
    }
}

/// Whether corrections become small enough. At the level of rounding they may cease to shrink.
bool GaussRadau15::sweep_until_converged(System& system, double time, double step) {
  constexpr int most_sweeps = 20;
  constexpr double of_rounding = 1e-13, small = 1e-9;
  const double next_to_nothing = 3e-8 * tolerance_;
  double last = std::numeric_limits<double>::infinity(), correction = last;
  for (int k = 1; k <= most_sweeps; ++k, last = correction) {
    correction = sweep(system, time, step);
    if (k > 1 && correction * std::min(1.0, correction / last) <= next_to_nothing) return true;
    if (k > 2 && correction >= last && correction <= of_rounding) return true;
  }
  return correction <= small;
}

/// Evaluates at every node once. Returns the largest correction, relative to the largest
/// acceleration at the last node.
double GaussRadau15::sweep(System& system, double time, double step) {
  Pack correction{}, size{};
  [&]<std::size_t... Node>(std::index_sequence<Node...>) {
    ((evaluate<Node>(system, time, step), correction = larger(correction, correct<Node>())), ...);
  }
  (std::make_index_sequence<nodes>());
  for (std::size_t p = 0; p < rate_.packs(); ++p) size = larger(size, magnitude(rate_[p]));
  const double largest = largest_of(size);
  return largest > 0 ? largest_of(correction) / largest : 0;
}

/// Puts the system to a node and takes its accelerations.
template <std::size_t Node>
void GaussRadau15::evaluate(System& system, double time, double step) {
  constexpr double part = node[Node];
  for (std::size_t p = 0; p < place_.packs(); ++p) {
    const Pack bend = (part * part / 2) * start_[p] + sum(node_place[Node], next_[p]);
    const Pack way = (part * step) * velocity_[p] + (step * step) * bend;
    moved_[p] = place_[p] + (way - lost_place_[p]);
  }
  moved_.give_values(system.drifted());
  system.prepare(time + part * step);
  system.update_kick_rates(time + part * step);
  rate_.take_rates(system.kicked());
}

/// Takes the change of the acceleration to this node as it is, and carries what is new of it on to
/// the later ones. Returns the size of what is new.
template <std::size_t Node>
Pack GaussRadau15::correct() {
  Pack largest{};
  for (std::size_t p = 0; p < next_.size(); ++p) {
    auto& of_node = next_[p];
    const Pack change = rate_[p] - start_[p], correction = change - of_node[Node];
    of_node[Node] = change;
    for (std::size_t k = Node + 1; k < nodes; ++k) of_node[k] += carried[Node][k] * correction;
    largest = larger(largest, magnitude(correction));
  }
  return largest;
}

/// The shortest time in which an acceleration changes by itself, from a and its derivatives at the
/// end of the step: T^2 = 2 a^2/(a'^2 + a a'') (Pham, Rein & Spiegel 2024), which is 0 where an
/// acceleration passes through 0, or T^2 = (a a'' + a'^2)/(a''^2 + a' a''') (Aarseth 1985), which
/// is not: the longer one.
double GaussRadau15::time_of_change(double step) {
  for (std::size_t p = 0; p < next_.size(); ++p) {
    moved_[p] = start_[p] + sum(to_end, next_[p]);
    jerk_[p] = sum(power_at_end[0], next_[p]);
    snap_[p] = 2 * sum(power_at_end[1], next_[p]);
    crackle_[p] = 6 * sum(power_at_end[2], next_[p]);
  }
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < count_; first += dimension_) {
    const auto square = [&](const PackedColumn& column) {
      const double* numbers = column.begin() + first;
      return std::inner_product(numbers, numbers + dimension_, numbers, 0.0);
    };
    const double a = square(moved_), j = square(jerk_), s = square(snap_), c = square(crackle_);
    const double by_acceleration = 2 * a / (j + std::sqrt(a * s));
    const double by_all = (std::sqrt(a * s) + j) / (s + std::sqrt(j * c));
    if (a > 0 || j > 0) shortest = std::min(shortest, std::fmax(by_acceleration, by_all));
  }
  return step * std::sqrt(shortest);
}

/// Goes to the end of the step. Terms are added from the smallest to the largest; what the weights
/// and the largest products lose to rounding is kept, since lost on every step it would make the
/// energy drift.
void GaussRadau15::accept(System& system, double step) {
  start_place_ = place_;
  start_velocity_ = velocity_;
  for (std::size_t p = 0; p < next_.size(); ++p) {
    const Pack way = step * velocity_[p], kick = step * start_[p];
    const Pack lost_kick = lost_of_product(step, start_[p], kick);
    const Pack rest = step * sum(to_place.rest, next_[p]) - lost_velocity_[p] + lost_kick / 2;
    add_term(place_[p], lost_place_[p], step * rest + lost_of_product(step, velocity_[p], way));
    add_term(place_[p], lost_place_[p], step * (step * sum(to_place.weight, next_[p])));
    add_term(place_[p], lost_place_[p], (step / 2) * kick);
    add_term(place_[p], lost_place_[p], way);
    add_term(velocity_[p], lost_velocity_[p], step * sum(to_velocity.rest, next_[p]) + lost_kick);
    add_term(velocity_[p], lost_velocity_[p], step * sum(to_velocity.weight, next_[p]));
    add_term(velocity_[p], lost_velocity_[p], kick);
  }
  std::swap(change_, next_);
  std::swap(predicted_, foretold_);
  last_step_ = step;
  predictions_ = std::min(predictions_ + 1, 2.0);
  place_.give_values(system.drifted());
  velocity_.give_values(system.kicked());
}

void GaussRadau15::go_along_path(System& system, double part) {
  if (part == 1) {
    place_.give_values(system.drifted());
    velocity_.give_values(system.kicked());
    return;
  }
  const auto [to_place, to_velocity] = path_weights(part);
  const double time = part * last_step_;
  for (std::size_t p = 0; p < change_.size(); ++p) {
    const Pack &x = start_place_[p], &v = start_velocity_[p], &a = start_[p];
    moved_[p] = x + time * (v + time * (a / 2 + sum(to_place, change_[p])));
    rate_[p] = v + time * (a + sum(to_velocity, change_[p]));
  }
  moved_.give_values(system.drifted());
  rate_.give_values(system.kicked());
}

/// Numbers and columns that go into a snapshot, in their order there.
template <class Visit>
void GaussRadau15::visit_memory(auto& method, Visit visit) {
  for (auto* number : {&method.last_step_, &method.next_step_, &method.predictions_})
    visit(number, 1);
  for (auto* column :
       {&method.place_, &method.velocity_, &method.lost_place_, &method.lost_velocity_,
        &method.start_place_, &method.start_velocity_, &method.start_})
    visit(column->begin(), column->packs() * pack_size);
  for (auto* of_nodes : {&method.change_, &method.predicted_})
    visit(numbers_of(*of_nodes), of_nodes->size() * nodes * pack_size);
}

std::vector<double> GaussRadau15::memory() const {
  if (last_step_ == 0) return {};
  std::vector<double> memory{static_cast<double>(count_)};
  visit_memory(*this, [&](const double* from, std::size_t size) {
    memory.insert(memory.end(), from, from + size);
  });
  return memory;
}

void GaussRadau15::recall(std::span<const double> memory) {
  resize(memory.empty() ? 0 : static_cast<std::size_t>(memory.front()));
  if (memory.empty()) return;
  const double* from = memory.data() + 1;
  visit_memory(*this, [&](double* to, std::size_t size) {
    std::copy_n(from, size, to);
    from += size;
  });
}

}  // namespace mote
