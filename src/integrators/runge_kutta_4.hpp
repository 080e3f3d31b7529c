#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/kept_values.hpp"

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
    Rates* const parts[] = {&drifted_, &kicked_};
    drifted_.start(system.drifted());
    kicked_.start(system.kicked());
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const double now = time + stages[s].node * step;
      system.prepare(now);
      system.update_kick_rates(now);
      system.update_drift_rates(now);
      for (Rates* part : parts) part->take(stages[s].weight);
      const double to_next = s + 1 < stages.size() ? stages[s + 1].node * step : 0;
      for (Rates* part : parts) part->go_on(to_next);
    }
    drift(system, drifted_.mean(), step);
    kick(system, kicked_.mean(), step);
  }

 private:
  /// Rates of one half of a system. A rate may be a value of the other half (dx/dt = v), so a
  /// stage's rates are copied before any value moves.
  class Rates {
   public:
    void start(std::span<const Evolving> parts) {
      kept_.keep(parts);
      rate_.resize(parts.size());
      mean_rate_.resize(parts.size());
      stage_.clear();
      mean_.clear();
      parts_ = parts;
      for (std::size_t part = 0; part < parts.size(); ++part) {
        rate_[part].resize(parts[part].value.size());
        mean_rate_[part].assign(parts[part].value.size(), 0);
        stage_.push_back({parts[part].value, rate_[part]});
        mean_.push_back({parts[part].value, mean_rate_[part]});
      }
    }

    void take(double weight) {
      for (std::size_t part = 0; part < parts_.size(); ++part)
        for (std::size_t i = 0; i < rate_[part].size(); ++i) {
          rate_[part][i] = parts_[part].rate[i];
          mean_rate_[part][i] += weight * rate_[part][i];
        }
    }

    void go_on(double step) { kept_.go_on(stage_, step); }
    std::span<const Evolving> mean() const { return mean_; }

   private:
    KeptValues kept_;
    std::span<const Evolving> parts_;
    std::vector<std::vector<double>> rate_, mean_rate_;
    std::vector<Evolving> stage_, mean_;
  };

  Rates drifted_, kicked_;
};

}  // namespace mote
