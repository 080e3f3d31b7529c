#pragma once

#include <array>
#include <complex>
#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// Two point vortices in an unbounded plane.
struct PointVortices {
  std::array<double, 2> circulation{};
  std::array<std::complex<double>, 2> place{};  ///< at the start, x + i y
};

/// Their motion: they keep their distance d and turn about the centre of their circulations at the
/// rate (Gamma_1 + Gamma_2)/(2 pi d^2); opposite ones, which have no centre, go straight on with
/// Gamma/(2 pi d). (Helmholtz 1858; Saffman 1992, section 7.2)
class VortexPair final : public FlowSolution {
 public:
  static constexpr std::string_view name = "vortex_pair";
  static constexpr std::string_view summary =
      "two point vortices that turn about each other, or go on side by side";

  explicit VortexPair(const PointVortices& vortices);

  std::string statement() const override;
  /// The velocity of the fluid; at a vortex that which the other one induces.
  Table at_places(std::span<const double> position, int dimension, double time) const override;
  bool knows_particles() const override { return true; }
  /// Places and velocities of the two.
  Table of_particles(double time) const override;

  std::array<std::complex<double>, 2> places(double time) const;
  double turning_rate() const { return rate_; }  ///< [radian/time]

 private:
  PointVortices start_;
  double rate_;
};

}  // namespace mote
