#pragma once

#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// A lattice of vortices in a plane, Taylor and Green (1937):
///   u =  U sin(k x + a) cos(k y + b),   v = -U cos(k x + a) sin(k y + b).
struct VortexLattice {
  double speed = 1;                 ///< U at the start
  double wave_number = 1;           ///< k = 2 pi n/L [1/length]
  double phase_x = 0, phase_y = 0;  ///< a and b
  double density = 1;
  double viscosity = 0;  ///< kinematic
  double mean_pressure = 0;
};

/// The decaying vortices, exact for incompressible flow: as lap u = -2 k^2 u, the velocity decays
/// with exp(-2 nu k^2 t), and the pressure, which balances the quadratic term alone,
///   p = p0 + rho U^2/4 (cos 2(k x + a) + cos 2(k y + b)) exp(-4 nu k^2 t).
class TaylorGreen final : public FlowSolution {
 public:
  static constexpr std::string_view name = "taylor_green";
  static constexpr std::string_view summary =
      "decaying vortices in a periodic box, incompressible, in two dimensions";

  explicit TaylorGreen(const VortexLattice& lattice) : lattice_(lattice) {}

  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  FlowState at(const std::array<double, 3>& place, double time) const;

 private:
  VortexLattice lattice_;
};

}  // namespace mote
