#pragma once

#include <string_view>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/kept_values.hpp"

namespace mote {

/// To the middle of the step with the rates of its start, and from its start over all of it with
/// the rates of the middle: the midpoint method (Runge 1895), all parts at once. Order 2.
class PredictorCorrector final : public Integrator {
 public:
  static constexpr std::string_view name = "predictor_corrector";
  static constexpr std::string_view summary = "order 2, two evaluations a step";
  static constexpr int order = 2;

  void advance_one_step(System& system, double time, double step) override {
    evaluate(system, time);
    drifted_.keep(system.drifted());
    kicked_.keep(system.kicked());
    // A drift rate may be a kicked value (dx/dt = v): what drifts moves first.
    drifted_.go_on(system.drifted(), step / 2);
    kicked_.go_on(system.kicked(), step / 2);
    evaluate(system, time + step / 2);
    drifted_.restore(system.drifted());
    drift(system, step);
    kicked_.restore(system.kicked());
    kick(system, step);
  }

 private:
  static void evaluate(System& system, double time) {
    system.prepare(time);
    system.update_kick_rates(time);
    system.update_drift_rates(time);
  }

  KeptValues drifted_, kicked_;
};

}  // namespace mote
