#pragma once

#include <string_view>

#include "mote/integrators/explicit_runge_kutta.hpp"

namespace mote {

/// The classical Runge-Kutta method of order 4, all parts at once.
class RungeKutta4 final : public ExplicitRungeKutta<RungeKutta4> {
 public:
  static constexpr std::string_view name = "runge_kutta_4";
  static constexpr std::string_view summary = "order 4, four evaluations a step";
  static constexpr int order = 4;

  static constexpr RungeKuttaTableau<4> tableau{
      .node = {0, 0.5, 0.5, 1},
      .matrix = {{{}, {0.5}, {0, 0.5}, {0, 0, 1}}},
      .weight = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6},
  };
};

}  // namespace mote
