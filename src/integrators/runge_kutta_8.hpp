#pragma once

#include <string_view>

#include "mote/integrators/explicit_runge_kutta.hpp"

namespace mote {

/// The eighth-order Runge-Kutta method of the ContEvol paper, equations (2.2.8)-(2.2.18), all parts
/// at once; corrected: the first coefficient of k7, (2.2.15), is -231 and not -234.
///
/// It is of order 8 for linear equations, forced ones too. For others it satisfies every condition
/// of order 7 and 64 of the 115 of order 8: no explicit method of ten stages can have them all
/// (Butcher 1985).
class RungeKutta8 final : public ExplicitRungeKutta<RungeKutta8> {
 public:
  static constexpr std::string_view name = "runge_kutta_8";
  static constexpr std::string_view summary =
      "order 8 for linear equations and 7 for others, ten evaluations a step";
  static constexpr int order = 7;
  static constexpr int order_for_linear_equations = 8;

  static constexpr RungeKuttaTableau<10> tableau{
      .node = {0, 4.0 / 27, 2.0 / 9, 1.0 / 3, 1.0 / 2, 2.0 / 3, 1.0 / 6, 1, 5.0 / 6, 1},
      .matrix = {{
          {},
          {4.0 / 27},
          {1.0 / 18, 3.0 / 18},
          {1.0 / 12, 0, 3.0 / 12},
          {1.0 / 8, 0, 0, 3.0 / 8},
          {13.0 / 54, 0, -27.0 / 54, 42.0 / 54, 8.0 / 54},
          {389.0 / 4320, 0, -54.0 / 4320, 966.0 / 4320, -824.0 / 4320, 243.0 / 4320},
          {-231.0 / 20, 0, 81.0 / 20, -1164.0 / 20, 656.0 / 20, -122.0 / 20, 800.0 / 20},
          {-127.0 / 288, 0, 18.0 / 288, -678.0 / 288, 456.0 / 288, -9.0 / 288, 576.0 / 288,
           4.0 / 288},
          {1481.0 / 820, 0, -81.0 / 820, 7104.0 / 820, -3376.0 / 820, 72.0 / 820, -5040.0 / 820,
           -60.0 / 820, 720.0 / 820},
      }},
      .weight = {41.0 / 840, 0, 0, 27.0 / 840, 272.0 / 840, 27.0 / 840, 216.0 / 840, 0, 216.0 / 840,
                 41.0 / 840},
  };
};

}  // namespace mote
