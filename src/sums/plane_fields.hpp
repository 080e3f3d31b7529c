#pragma once

#include <array>

#include "mote/sums/biot_savart_kernels.hpp"
#include "mote/sums/far_field.hpp"
#include "mote/sums/gravity_kernels.hpp"
#include "mote/sums/laurent_expansion.hpp"

namespace mote {

/// The far fields of pair kernels in the plane, from f(z) = sum_j s_j/(z - t_j): what they have in
/// common, a Taylor series of f about the centre of a node.
class PlaneField {
 public:
  PlaneField(const LaurentExpansion& expansion, const double* taylor, double radius)
      : expansion_(expansion), taylor_(taylor), radius_(radius) {}

 protected:
  LaurentExpansion::Values values_at(const std::array<Lanes, 2>& offset, bool with_slope) const {
    return expansion_.values(taylor_, offset[0] / radius_, offset[1] / radius_, with_slope);
  }
  double constant() const { return expansion_.constant(taylor_); }
  double radius() const { return radius_; }

 private:
  const LaurentExpansion& expansion_;
  const double* taylor_;
  double radius_;
};

/// Vortices of circulation s_j, without the factor 1/(2 pi): u = Im f, v = Re f, and so
/// du/dx = -dv/dy = Im f', du/dy = dv/dx = Re f'.
template <class Shape, bool WithGradient>
requires(Shape::dimension == 2) class FarField<VortexKernel<Shape, WithGradient>> : PlaneField {
 public:
  using PlaneField::PlaneField;

  template <std::size_t N>
  void add(const std::array<Lanes, 2>& offset, std::array<Lanes, N>& sums) const {
    const auto values = values_at(offset, WithGradient);
    sums[0] += values.imaginary;
    sums[1] += values.real;
    if constexpr (WithGradient) {
      const Lanes real = values.slope_real / radius(),
                  imaginary = values.slope_imaginary / radius();
      sums[2] += imaginary;
      sums[3] += real;
      sums[4] += real;
      sums[5] -= imaginary;
    }
  }
};

/// Masses s_j: the potential is the real part of the integral of f, its gradient (Re f, -Im f).
template <class Shape, GravityPart Part>
requires(Shape::dimension == 2) class FarField<GravityKernel<Shape, Part>> : PlaneField {
 public:
  using PlaneField::PlaneField;

  template <std::size_t N>
  void add(const std::array<Lanes, 2>& offset, std::array<Lanes, N>& sums) const {
    const auto values = values_at(offset, false);
    if constexpr (Part != GravityPart::gradient) sums[0] += constant() + radius() * values.integral;
    if constexpr (Part != GravityPart::potential) {
      sums[N - 2] += values.real;
      sums[N - 1] -= values.imaginary;
    }
  }
};

}  // namespace mote
