#pragma once

#include <string_view>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// Half a kick, drift, half a kick. Order 2 and symplectic where accelerations depend on positions
/// alone, and exact where they are constant; order 1 where they depend on velocities.
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
    system.update_drift_rates(time + step / 2);
    drift(system.drifted(), step);
    system.prepare(time + step);
    system.update_kick_rates(time + step);
    kick(system.kicked(), step / 2);
  }
};

}  // namespace mote
