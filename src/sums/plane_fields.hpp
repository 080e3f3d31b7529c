#pragma once

#include <array>

#include "mote/sums/gravity_kernels.hpp"
#include "mote/sums/laurent_expansion.hpp"

namespace mote {

/// The far fields of the pair kernels in the plane, from f(z) = sum_j s_j/(z - t_j).

/// A Cauchy sum: f itself.
class PlaneCauchy {
 public:
  explicit PlaneCauchy(double tolerance) : expansion_(tolerance, false) {}
  const LaurentExpansion& expansion() const { return expansion_; }

  void add(const double* taylor, double /*radius*/, const std::array<Lanes, 2>& place,
           std::array<Lanes, 2>& sums) const {
    const auto values = expansion_.values(taylor, place[0], place[1], false);
    sums[0] += values.real;
    sums[1] += values.imaginary;
  }

 private:
  LaurentExpansion expansion_;
};

/// Vortices of circulation s_j, without the factor 1/(2 pi): u = Im f, v = Re f, and so
/// du/dx = -dv/dy = Im f', du/dy = dv/dx = Re f'.
template <bool WithGradient>
class PlaneVortices {
 public:
  explicit PlaneVortices(double tolerance) : expansion_(tolerance, false) {}
  const LaurentExpansion& expansion() const { return expansion_; }

  void add(const double* taylor, double radius, const std::array<Lanes, 2>& place,
           std::array<Lanes, WithGradient ? 6 : 2>& sums) const {
    const auto values = expansion_.values(taylor, place[0], place[1], WithGradient);
    sums[0] += values.imaginary;
    sums[1] += values.real;
    if constexpr (WithGradient) {
      const Lanes real = values.slope_real / radius, imaginary = values.slope_imaginary / radius;
      sums[2] += imaginary;
      sums[3] += real;
      sums[4] += real;
      sums[5] -= imaginary;
    }
  }

 private:
  LaurentExpansion expansion_;
};

/// Masses s_j: the potential is the real part of the integral of f, its gradient (Re f, -Im f).
template <GravityPart Part>
class PlaneMasses {
 public:
  static constexpr bool has_potential = Part != GravityPart::gradient;
  static constexpr bool has_gradient = Part != GravityPart::potential;
  static constexpr std::size_t outputs = (has_potential ? 1 : 0) + (has_gradient ? 2 : 0);

  explicit PlaneMasses(double tolerance) : expansion_(tolerance, has_potential) {}
  const LaurentExpansion& expansion() const { return expansion_; }

  void add(const double* taylor, double radius, const std::array<Lanes, 2>& place,
           std::array<Lanes, outputs>& sums) const {
    const auto values = expansion_.values(taylor, place[0], place[1], false);
    if constexpr (has_potential) sums[0] += expansion_.constant(taylor) + radius * values.integral;
    if constexpr (has_gradient) {
      sums[outputs - 2] += values.real;
      sums[outputs - 1] -= values.imaginary;
    }
  }

 private:
  LaurentExpansion expansion_;
};

}  // namespace mote
