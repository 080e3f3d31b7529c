#pragma once

#include "mote/sums/pair_kernel.hpp"
#include "mote/sums/pair_shapes.hpp"

namespace mote {

/// The velocity that vortices induce, without the factor 1/(2 pi) or 1/(4 pi): first its
/// components, and then, if asked for, du_a/dx_b at place D a + b.
template <class Shape, bool WithGradient>
struct VortexKernel;

/// Gamma k with k = f (-y, x), f = q/r^2:   dk_a/dx_b = d(-y, x)_a/dx_b f + (-y, x)_a x_b f'/r.
template <class Shape, bool WithGradient>
requires(Shape::dimension == 2) struct VortexKernel<Shape, WithGradient> {
  static constexpr int dimension = 2, strengths = 1, outputs = WithGradient ? 6 : 2;

  [[no_unique_address]] Shape shape;

  [[gnu::always_inline]] void add(const std::array<Lanes, 2>& difference,
                                  const std::array<double, 1>& circulation,
                                  const typename Shape::At& at,
                                  std::array<Lanes, outputs>& sums) const {
    const auto& [x, y] = difference;
    const Lanes influence = circulation[0] * at.influence();
    sums[0] = fused(-influence, y, sums[0]);
    sums[1] = fused(influence, x, sums[1]);
    if constexpr (WithGradient) {
      const Lanes slope = circulation[0] * at.influence_slope();
      const Lanes shear = slope * x * y;
      sums[2] -= shear;
      sums[3] -= influence + slope * y * y;
      sums[4] += influence + slope * x * x;
      sums[5] += shear;
    }
  }
};

/// alpha x r f with f = q/r^3:   du_a/dx_b = e_acb alpha_c f + (alpha x r)_a r_b f'/r.
template <class Shape, bool WithGradient>
requires(Shape::dimension == 3) struct VortexKernel<Shape, WithGradient> {
  static constexpr int dimension = 3, strengths = 3, outputs = WithGradient ? 12 : 3;

  [[no_unique_address]] Shape shape;

  [[gnu::always_inline]] void add(const std::array<Lanes, 3>& r, const std::array<double, 3>& alpha,
                                  const typename Shape::At& at,
                                  std::array<Lanes, outputs>& sums) const {
    const Lanes influence = at.influence();
    std::array<Lanes, 3> cross;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      cross[a] = fused(alpha[b], r[c], -(alpha[c] * r[b]));
      sums[a] = fused(influence, cross[a], sums[a]);
    }
    if constexpr (WithGradient) {
      const Lanes slope = at.influence_slope();
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const Lanes along = slope * cross[a];
        sums[3 + 3 * a + a] += along * r[a];
        sums[3 + 3 * a + b] += along * r[b] - influence * alpha[c];
        sums[3 + 3 * a + c] += along * r[c] + influence * alpha[b];
      }
    }
  }
};

}  // namespace mote
