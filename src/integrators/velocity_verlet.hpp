#pragma once

#include <string_view>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/kept_values.hpp"

namespace mote {

/// Half a kick, drift, half a kick. Order 2 and symplectic where accelerations depend on positions
/// alone, and exact where they are constant; order 1 where they depend on velocities. Where drift
/// rates depend on what drifts, they are taken at the middle of the step.
class VelocityVerlet final : public Integrator {
 public:
  static constexpr std::string_view name = "velocity_verlet";
  static constexpr std::string_view summary =
      "order 2 where accelerations do not depend on velocities";
  static constexpr int order = 2;

  void advance_one_step(System& system, double time, double step) override {
    system.prepare(time);
    system.update_kick_rates(time);
    kick(system.kicked(), step / 2);
    system.update_drift_rates(time);
    if (!system.drifts_freely()) update_rates_at_the_middle(system, time, step);
    drift(system.drifted(), step);
    system.prepare(time + step);
    system.update_kick_rates(time + step);
    kick(system.kicked(), step / 2);
  }

 private:
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
