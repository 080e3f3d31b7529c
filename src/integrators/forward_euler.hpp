#pragma once

#include <string_view>

#include "mote/integrators/integrator.hpp"

namespace mote {

/// y(t + h) = y + h y'(y), all parts at once; the paper's method. Order 1.
class ForwardEuler final : public Integrator {
 public:
  static constexpr std::string_view name = "forward_euler";
  static constexpr std::string_view summary = "order 1, all rates from the start of the step";
  static constexpr int order = 1;

  void advance_one_step(System& system, double time, double step) override {
    system.prepare(time);
    system.update_kick_rates(time);
    system.update_drift_rates(time);
    drift(system, step);
    kick(system, step);
  }
};

}  // namespace mote
