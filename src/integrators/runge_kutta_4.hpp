#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// The classical Runge-Kutta method of order 4, all parts at once.
class RungeKutta4 final : public Integrator {
 public:
  static constexpr std::string_view name = "runge_kutta_4";
  static constexpr std::string_view summary = "order 4, four evaluations a step";
  static constexpr int order = 4;

  void advance_one_step(System& system, double time, double step) override {
    struct Stage {
      double node;    ///< where the stage evaluates, in steps
      double weight;  ///< of its rate in the result
    };
    static constexpr std::array<Stage, 4> stages{
        {{0, 1.0 / 6}, {0.5, 1.0 / 3}, {0.5, 1.0 / 3}, {1, 1.0 / 6}}};
    keep_start(system);
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const double now = time + stages[s].node * step;
      system.prepare(now);
      system.update_kick_rates(now);
      system.update_drift_rates(now);
      add_rates(system, stages[s].weight);
      if (s + 1 < stages.size()) go_from_start(system, stages[s + 1].node * step);
    }
    return_to_start(system);
    drift(with_mean_rates(system.drifted(), 0), step);
    kick(with_mean_rates(system.kicked(), system.drifted().size()), step);
  }

 private:
  /// Calls visit(part, evolving) for the drifted and then the kicked parts.
  template <class Visit>
  static void for_each_part(System& system, Visit visit) {
    std::size_t part = 0;
    for (const Evolving& evolving : system.drifted()) visit(part++, evolving);
    for (const Evolving& evolving : system.kicked()) visit(part++, evolving);
  }

  void keep_start(System& system) {
    const std::size_t parts = system.drifted().size() + system.kicked().size();
    for (auto* room : {&start_, &rate_, &mean_rate_}) room->resize(parts);
    for_each_part(system, [&](std::size_t part, const Evolving& evolving) {
      start_[part].assign(evolving.value.begin(), evolving.value.end());
      mean_rate_[part].assign(evolving.value.size(), 0);
    });
  }

  /// Takes a stage's rates, all before any value changes: a rate may be another part's value.
  void add_rates(System& system, double weight) {
    for_each_part(system, [&](std::size_t part, const Evolving& evolving) {
      rate_[part].assign(evolving.rate.begin(), evolving.rate.end());
      for (std::size_t i = 0; i < rate_[part].size(); ++i)
        mean_rate_[part][i] += weight * rate_[part][i];
    });
  }

  void go_from_start(System& system, double step) {
    for_each_part(system, [&](std::size_t part, const Evolving& evolving) {
      for (std::size_t i = 0; i < evolving.value.size(); ++i)
        evolving.value[i] = start_[part][i] + step * rate_[part][i];
    });
  }

  void return_to_start(System& system) {
    for_each_part(system, [&](std::size_t part, const Evolving& evolving) {
      std::ranges::copy(start_[part], evolving.value.begin());
    });
  }

  /// The same parts with the mean rates of the step, which are kept from part `first` on.
  std::span<const Evolving> with_mean_rates(std::span<const Evolving> parts, std::size_t first) {
    averaged_.clear();
    for (const Evolving& part : parts) averaged_.push_back({part.value, mean_rate_[first++]});
    return averaged_;
  }

  std::vector<std::vector<double>> start_, rate_, mean_rate_;
  std::vector<Evolving> averaged_;
};

}  // namespace mote
