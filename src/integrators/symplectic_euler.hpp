#pragma once

#include <string_view>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// Kick, then drift with the new velocities. Order 1, symplectic where accelerations depend on
/// positions alone.
class SymplecticEuler final : public Integrator {
 public:
  static constexpr std::string_view name = "symplectic_euler";
  static constexpr std::string_view summary = "order 1, drifts with the new velocities";
  static constexpr int order = 1;

  void advance_one_step(System& system, double time, double step) override {
    system.prepare(time);
    system.update_kick_rates(time);
    kick(system, step);
    system.update_drift_rates(time);
    drift(system, step);
  }
};

}  // namespace mote
