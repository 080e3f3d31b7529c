#pragma once

#include <string_view>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/kept_values.hpp"

namespace mote {

/// Half a kick, drift, half a kick. Order 2 and symplectic where accelerations depend on positions
/// alone, and exact where they are constant. Where they depend on velocities it is of order 2 for a
/// system that predicts, and else of order 1. Where drift rates depend on what drifts, they are
/// taken at the middle of the step, unless the system predicts.
class VelocityVerlet final : public Integrator {
 public:
  static constexpr std::string_view name = "velocity_verlet";
  static constexpr std::string_view summary =
      "order 2 where accelerations do not depend on velocities, or the model predicts those";
  static constexpr int order = 2;

  void advance_one_step(System& system, double time, double step) override {
    if (system.predicts()) return advance_with_prediction(system, time, step);
    system.prepare(time);
    system.update_kick_rates(time);
    kick(system, step / 2);
    system.update_drift_rates(time);
    if (!system.drifts_freely()) update_rates_at_the_middle(system, time, step);
    drift(system, step);
    system.prepare(time + step);
    system.update_kick_rates(time + step);
    kick(system, step / 2);
  }

 private:
  /// The rates at the end, with the velocities at the end predicted, are those that the next step
  /// starts with: one evaluation a step. Their error, of order step^2, does not lower the order.
  void advance_with_prediction(System& system, double time, double step) {
    if (!system.rates_are_current()) {
      system.prepare(time);
      system.update_kick_rates(time);
    }
    kick(system, step / 2);
    system.update_drift_rates(time);
    drift(system, step);
    system.prepare(time + step);
    system.update_rates_ahead(time + step, step / 2);
    kick(system, step / 2);
  }

  void update_rates_at_the_middle(System& system, double time, double step) {
    start_.keep(system.drifted());
    start_.go_on(system.drifted(), step / 2);
    system.prepare(time + step / 2);
    system.update_drift_rates(time + step / 2);
    start_.restore(system.drifted());
  }

  KeptValues start_;
};

}  // namespace mote
