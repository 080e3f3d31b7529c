#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "mote/exact/flow_solution.hpp"

namespace mote::test {

/// What the equations of an incompressible flow in a plane are to hold, at one place and time.
struct FlowConstants {
  double density = 1, viscosity = 0;
  std::array<double, 2> force{};  ///< per mass
  bool linear = false;            ///< without (u . grad) u
};

/// Largest residual of rho (u_t + u . grad u - nu lap u - f) + grad p = 0 and div u = 0, by central
/// differences of length h, in units of what stands in the equation.
inline double flow_residual(const FlowSolution& flow, const FlowConstants& constants, double x,
                            double y, double t, double h = 1e-4) {
  struct State {
    double u, v, p;
  };
  const auto at = [&](double dx, double dy, double dt) {
    const double place[] = {x + dx, y + dy};
    const Table table = flow.at_places(place, 2, t + dt);
    return State{table[0].values[0], table[1].values[0],
                 table.size() > 2 ? table[2].values[0] : 0.0};
  };
  const State here = at(0, 0, 0), east = at(h, 0, 0), west = at(-h, 0, 0), north = at(0, h, 0),
              south = at(0, -h, 0), later = at(0, 0, h), earlier = at(0, 0, -h);
  const auto momentum = [&](double State::*component, double pressure_slope, double force) {
    const double rate = (later.*component - earlier.*component) / (2 * h);
    const double along_x = (east.*component - west.*component) / (2 * h);
    const double along_y = (north.*component - south.*component) / (2 * h);
    const double carried = constants.linear ? 0 : here.u * along_x + here.v * along_y;
    const double laplacian = (east.*component + west.*component + north.*component +
                              south.*component - 4 * (here.*component)) /
                             (h * h);
    const double slope = pressure_slope / constants.density;
    const double size = std::abs(rate) + std::abs(carried) + std::abs(slope) + std::abs(force) +
                        std::abs(constants.viscosity * laplacian);
    return std::abs(rate + carried - constants.viscosity * laplacian - force + slope) /
           std::max(size, 1e-300);
  };
  const double stretch = (east.u - west.u) / (2 * h), squeeze = (north.v - south.v) / (2 * h);
  const double size = std::abs(stretch) + std::abs(squeeze);
  return std::max({momentum(&State::u, (east.p - west.p) / (2 * h), constants.force[0]),
                   momentum(&State::v, (north.p - south.p) / (2 * h), constants.force[1]),
                   size > 0 ? std::abs(stretch + squeeze) / size : 0});
}

}  // namespace mote::test
