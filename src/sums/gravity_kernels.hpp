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
                                  const std::array<double, 1>& mass,
                                  std::array<Lanes, outputs>& sums) const {
    const Lanes r_squared = square_of<dimension>(difference);
    if constexpr (has_potential) {
      constexpr double sign = dimension == 2 ? 1 : -1;
      sums[0] += sign * mass[0] * shape.potential(r_squared);
    }
    if constexpr (has_gradient) {
      const Lanes factor = mass[0] * shape.influence(r_squared);
      for (int d = 0; d < dimension; ++d)
        sums[d + (has_potential ? 1 : 0)] += factor * difference[d];
    }
  }
};

}  // namespace mote
