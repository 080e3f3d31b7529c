#pragma once

#include <array>
#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// A vortex whose vorticity is a Gauss function.
struct GaussVortex {
  double circulation = 1;
  std::array<double, 2> centre{};
  double variance = 1;   ///< of its vorticity along each axis at the start, 2 nu t for a vortex
                         ///< that was a point at -t [length^2]
  double viscosity = 0;  ///< kinematic
};

/// The vortex that friction spreads, Lamb (1932), section 334a: with s^2 = variance + 2 nu t,
///   omega = Gamma/(2 pi s^2) exp(-r^2/(2 s^2)),   u = Gamma/(2 pi r) (1 - exp(-r^2/(2 s^2))).
/// Its highest velocity, 0.638173 Gamma/(2 pi sqrt(2) s), is at r = 1.120906 sqrt(2) s.
class LambOseen final : public FlowSolution {
 public:
  static constexpr std::string_view name = "lamb_oseen";
  static constexpr std::string_view summary =
      "a vortex that spreads by friction in an unbounded plane";

  explicit LambOseen(const GaussVortex& vortex) : vortex_(vortex) {}

  std::string statement() const override;
  /// Velocity and vorticity.
  Table at_places(std::span<const double> position, int dimension, double time) const override;

  double variance(double time) const { return vortex_.variance + 2 * vortex_.viscosity * time; }

 private:
  GaussVortex vortex_;
};

}  // namespace mote
