#pragma once

#include <array>

#include "mote/sums/biot_savart_kernels.hpp"
#include "mote/sums/far_field.hpp"
#include "mote/sums/gravity_kernels.hpp"
#include "mote/sums/harmonic_field.hpp"
#include "mote/sums/space_expansion.hpp"

namespace mote {

/// The far fields of pair kernels in space, from A(x) = sum_j s_j/|x - x_j|.

/// Vortices of circulation s_j, without the factor 1/(4 pi): sum_j s_j x r/r^3 is the curl of A.
template <class Shape, bool WithGradient>
requires(Shape::dimension == 3) class FarField<VortexKernel<Shape, WithGradient>> {
 public:
  static constexpr auto parts = [] {
    if constexpr (WithGradient)
      return std::array{FieldPart{0, 3, 1}, FieldPart{3, 9, 2}};
    else
      return std::array{FieldPart{0, 3, 1}};
  }();

  FarField(const SpaceExpansion& expansion, const double* local, double radius)
      : curl_(expansion.degree()) {
    curl_.prepare(local, {{0, 0, 0}, radius}, WithGradient);
  }

  template <std::size_t N>
  void add(const std::array<Lanes, 3>& offset, std::array<Lanes, N>& sums) const {
    const std::array<Lanes, N> values = [&] {
      if constexpr (WithGradient)
        return curl_.with_gradient(offset);
      else
        return curl_.at(offset);
    }();
    for (std::size_t c = 0; c < N; ++c) sums[c] += values[c];
  }

 private:
  CurlField curl_;
};

/// Masses s_j: the potential is -A, its gradient -grad A.
template <class Shape, GravityPart Part>
requires(Shape::dimension == 3) class FarField<GravityKernel<Shape, Part>> {
 public:
  static constexpr auto parts = [] {
    if constexpr (Part == GravityPart::both)
      return std::array{FieldPart{0, 1, 0}, FieldPart{1, 3, 1}};
    else if constexpr (Part == GravityPart::potential)
      return std::array{FieldPart{0, 1, 0}};
    else
      return std::array{FieldPart{0, 3, 1}};
  }();

  FarField(const SpaceExpansion& expansion, const double* local, double radius)
      : potential_(expansion.degree_within(local, radius)) {
    potential_.prepare(local, {{0, 0, 0}, radius});
  }

  template <std::size_t N>
  void add(const std::array<Lanes, 3>& offset, std::array<Lanes, N>& sums) const {
    const std::array<Lanes, 4> values = potential_.at(offset);
    constexpr std::size_t first = Part == GravityPart::gradient ? 1 : 0;
    for (std::size_t c = 0; c < N; ++c) sums[c] -= values[first + c];
  }

 private:
  PotentialField potential_;
};

}  // namespace mote
