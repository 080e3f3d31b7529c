#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "mote/integrators/elementwise.hpp"
#include "mote/integrators/kept_values.hpp"
#include "mote/integrators/system.hpp"

namespace mote {

/// One half of a system on its way through the stages of a Runge-Kutta step: its values at the
/// start, and the rates of every stage. A rate may be a value of the other half (dx/dt = v), so
/// rates are copied before any value moves.
class HalfStages {
 public:
  void start(std::span<const Evolving> parts, std::size_t stages) {
    parts_ = parts;
    start_.keep(parts);
    rate_.resize(stages);
    for (auto& rate : rate_) shape(rate);
    shape(combined_);
    combination_.clear();
    for (std::size_t part = 0; part < parts.size(); ++part)
      combination_.push_back({parts[part].value, combined_[part]});
  }

  std::span<const Evolving> parts() const { return parts_; }
  const KeptValues& values_at_start() const { return start_; }

  /// Copies the system's rates as those of this stage.
  void take(std::size_t stage) {
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      const std::span<const double> from = parts_[part].rate;
      const std::span<double> to = rate_[stage][part];
      for_each_element(from.size(), [=](auto i) { to[i] = from[i]; });
    }
  }

  bool is_finite(std::size_t stage) const {
    for (const auto& part : rate_[stage])
      for (const double rate : part)
        if (!std::isfinite(rate)) return false;
    return true;
  }

  /// sum_s weight[s] * rate of stage s, in the order of s. What it returns is overwritten by the
  /// next call.
  std::span<const Evolving> combined(std::span<const double> weights) {
    for (std::size_t part = 0; part < combined_.size(); ++part) {
      terms_.clear();
      for (std::size_t stage = 0; stage < weights.size(); ++stage)
        if (weights[stage] != 0) terms_.push_back({weights[stage], rate_[stage][part].data()});
      add_up(terms_, combined_[part]);
    }
    return combination_;
  }

  /// Puts the system's values at those of the start + step * sum_s weight[s] * rate of stage s.
  void go_to(std::span<const double> weights, double step) {
    start_.go_on(combined(weights), step);
  }

 private:
  using Arrays = std::vector<std::vector<double>>;
  struct Term {
    double weight;
    const double* rate;
  };

  void shape(Arrays& arrays) const {
    arrays.resize(parts_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part)
      arrays[part].resize(parts_[part].value.size());
  }

  static void add_up(std::span<const Term> terms, std::span<double> sums) {
    for_each_element(sums.size(), [=](auto i) {
      double sum = 0;
      for (const Term& term : terms) sum += term.weight * term.rate[i];
      sums[i] = sum;
    });
  }

  std::span<const Evolving> parts_;
  KeptValues start_;
  std::vector<Arrays> rate_;
  Arrays combined_;
  std::vector<Term> terms_;
  std::vector<Evolving> combination_;
};

/// A whole system on its way through the stages of a Runge-Kutta step, all parts at once.
class Stages {
 public:
  void start(System& system, std::size_t stages) {
    drifted.start(system.drifted(), stages);
    kicked.start(system.kicked(), stages);
  }

  /// Forms the rates of the state that the system is in, as those of this stage.
  void evaluate(System& system, double time, std::size_t stage) {
    system.prepare(time);
    system.update_kick_rates(time);
    system.update_drift_rates(time);
    drifted.take(stage);
    kicked.take(stage);
  }

  bool is_finite(std::size_t stage) const {
    return drifted.is_finite(stage) && kicked.is_finite(stage);
  }

  void go_to(std::span<const double> weights, double step) {
    drifted.go_to(weights, step);
    kicked.go_to(weights, step);
  }

  void return_to_start() const {
    drifted.values_at_start().restore(drifted.parts());
    kicked.values_at_start().restore(kicked.parts());
  }

  HalfStages drifted, kicked;
};

}  // namespace mote
