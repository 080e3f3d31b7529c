#pragma once

#include <array>
#include <cstddef>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/stages.hpp"

namespace mote {

/// Coefficients of an explicit Runge-Kutta method (Butcher 1964): stage s is evaluated after
/// node[s] steps, at the start + step * sum_r matrix[s][r] * rate of stage r.
template <std::size_t stages>
struct RungeKuttaTableau {
  std::array<double, stages> node;
  std::array<std::array<double, stages>, stages> matrix;
  std::array<double, stages> weight;  ///< of each stage's rate in the step
};

/// Steps of the explicit Runge-Kutta method whose coefficients are `Method::tableau`, all parts of
/// the system at once.
template <class Method>
class ExplicitRungeKutta : public Integrator {
 public:
  void advance_one_step(System& system, double time, double step) final {
    const auto& tableau = Method::tableau;
    stages_.start(system, tableau.node.size());
    stages_.evaluate(system, time, 0);
    for (std::size_t stage = 1; stage < tableau.node.size(); ++stage) {
      stages_.go_to(tableau.matrix[stage], step);
      stages_.evaluate(system, time + tableau.node[stage] * step, stage);
    }
    stages_.return_to_start();
    drift(system, stages_.drifted.combined(tableau.weight), step);
    kick(system, stages_.kicked.combined(tableau.weight), step);
  }

 private:
  Stages stages_;
};

}  // namespace mote
