#pragma once

#include <string_view>

#include "mote/integrators/explicit_runge_kutta.hpp"

namespace mote {

/// With the mean of the rates at the start and where they lead to (Heun 1900), all parts at once.
class Heun final : public ExplicitRungeKutta<Heun> {
 public:
  static constexpr std::string_view name = "heun";
  static constexpr std::string_view summary =
      "order 2, two evaluations a step, with the mean of the rates at its ends";
  static constexpr int order = 2;

  static constexpr RungeKuttaTableau<2> tableau{
      .node = {0, 1},
      .matrix = {{{}, {1}}},
      .weight = {0.5, 0.5},
  };
};

}  // namespace mote
