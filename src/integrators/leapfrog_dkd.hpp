#pragma once

#include <string>
#include <string_view>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// Half a drift, kick, half a drift: the other leapfrog, with one evaluation a step, in its middle.
/// Symplectic where accelerations follow from time and places alone.
class LeapfrogDkd final : public Integrator {
 public:
  static constexpr std::string_view name = "leapfrog_dkd";
  static constexpr std::string_view summary =
      "order 2, symplectic: drift, kick, drift, one evaluation a step";
  static constexpr int order = 2;

  std::string missing_in(System& system) const override {
    return system.drifts_freely() ? "" : "drift rates that follow from velocities alone";
  }

  void advance_one_step(System& system, double time, double step) override {
    const double middle = time + step / 2;
    system.prepare(time);
    system.update_drift_rates(time);
    drift(system, step / 2);
    system.prepare(middle);
    system.update_kick_rates(middle);
    kick(system, step);
    system.update_drift_rates(middle);
    drift(system, step / 2);
  }
};

}  // namespace mote
