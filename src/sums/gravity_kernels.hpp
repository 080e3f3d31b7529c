#pragma once

#include "mote/sums/pair_kernel.hpp"
#include "mote/sums/pair_shapes.hpp"

namespace mote {

/// Gravity of masses without the gravitational constant: the potential, m ln r in 2D and -m/r in
/// 3D, its gradient, m q x/r^D, or first the one and then the other.
enum class GravityPart { potential, gradient, both };

template <class Shape, GravityPart Part>
struct GravityKernel {
  static constexpr int dimension = Shape::dimension, strengths = 1;
  static constexpr bool has_potential = Part != GravityPart::gradient;
  static constexpr bool has_gradient = Part != GravityPart::potential;
  static constexpr int outputs = (has_potential ? 1 : 0) + (has_gradient ? dimension : 0);

  [[no_unique_address]] Shape shape;

  [[gnu::always_inline]] void add(const std::array<Lanes, dimension>& difference,
                                  const std::array<double, 1>& mass, const typename Shape::At& at,
                                  std::array<Lanes, outputs>& sums) const {
    constexpr double sign = dimension == 2 ? 1 : -1;
    if constexpr (Part == GravityPart::potential) {
      sums[0] = fused(sign * mass[0], at.potential(), sums[0]);
    } else if constexpr (Part == GravityPart::gradient) {
      pull(mass[0] * at.influence(), difference, &sums[0]);
    } else {
      const auto [potential, influence] = at.both(mass[0]);
      sums[0] += sign * potential;
      pull(influence, difference, &sums[1]);
    }
  }

 private:
  [[gnu::always_inline]] static void pull(const Lanes& influence,
                                          const std::array<Lanes, dimension>& difference,
                                          Lanes* gradient) {
    for (int d = 0; d < dimension; ++d) gradient[d] = fused(influence, difference[d], gradient[d]);
  }
};

}  // namespace mote
