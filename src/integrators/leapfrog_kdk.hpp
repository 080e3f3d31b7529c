#pragma once

#include <string>
#include <string_view>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// Half a kick, drift, half a kick: the leapfrog as textbooks have it (Hockney and Eastwood 1981).
/// Symplectic where accelerations follow from time and places alone; `velocity_verlet` is the same
/// there, and goes on to what flows need.
class LeapfrogKdk final : public Integrator {
 public:
  static constexpr std::string_view name = "leapfrog_kdk";
  static constexpr std::string_view summary =
      "order 2, symplectic: kick, drift, kick, without velocity_verlet's care for flows";
  static constexpr int order = 2;

  std::string missing_in(System& system) const override {
    return system.drifts_freely() ? "" : "drift rates that follow from velocities alone";
  }

  void advance_one_step(System& system, double time, double step) override {
    system.prepare(time);
    system.update_kick_rates(time);
    kick(system, step / 2);
    system.update_drift_rates(time);
    drift(system, step);
    system.prepare(time + step);
    system.update_kick_rates(time + step);
    kick(system, step / 2);
  }
};

}  // namespace mote
