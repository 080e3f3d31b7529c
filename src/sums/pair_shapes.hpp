#pragma once

#include <cmath>

#include "mote/operators/cores/core.hpp"
#include "mote/operators/cores/lane_functions.hpp"

namespace mote {

/// How the field of one source depends on the distance, for eight targets at a time:
///   influence        q/r^D,
///   influence_slope  (1/r) d(q/r^D)/dr,
///   potential        2D: ln r, 3D: 1/r, or what takes their place within a core,
///   reach            the distance beyond which it is a point's to within a tolerance.

/// A point, q = 1. On its own place it does nothing.
template <int D>
struct PointShape {
  static constexpr int dimension = D;
  static constexpr bool has_size = false;
  static PointShape of_size(double) { return {}; }
  static double reach(double) { return 0; }

  [[gnu::always_inline]] static Lanes influence(const Lanes& r_squared) {
    const Lanes inverse = inverse_square(r_squared);
    if constexpr (D == 2) return inverse;
    if constexpr (D == 3) return inverse * sqrt(inverse);
  }
  [[gnu::always_inline]] static Lanes influence_slope(const Lanes& r_squared) {
    return -D * influence(r_squared) * inverse_square(r_squared);
  }
  [[gnu::always_inline]] static Lanes potential(const Lanes& r_squared) {
    if constexpr (D == 3) return sqrt(inverse_square(r_squared));
    Lanes result = 0.5 * logarithm(r_squared);
    where(r_squared == 0, result) = 0;
    return result;
  }

 private:
  [[gnu::always_inline]] static Lanes inverse_square(const Lanes& r_squared) {
    Lanes inverse = 1 / r_squared;
    where(r_squared == 0, inverse) = 0;
    return inverse;
  }
};

/// A blob of this core and size.
template <int D, VortexCore Core>
struct BlobShape {
  static constexpr int dimension = D;
  static constexpr bool has_size = true;
  static BlobShape of_size(double size) { return BlobShape(size); }

  explicit BlobShape(double size)
      : size_(size),
        per_square_(1 / (size * size)),
        per_power_(D == 2 ? per_square_ : per_square_ / size),
        potential_scale_(D == 2 ? std::log(size) : 1 / size) {}

  double reach(double tolerance) const { return size_ * Core::template reach<D>(tolerance); }

  [[gnu::always_inline]] Lanes influence(const Lanes& r_squared) const {
    return per_power_ * Core::template influence<D>(per_square_ * r_squared);
  }
  [[gnu::always_inline]] Lanes influence_slope(const Lanes& r_squared) const {
    return per_power_ * per_square_ * Core::template influence_slope<D>(per_square_ * r_squared);
  }
  [[gnu::always_inline]] Lanes potential(const Lanes& r_squared) const {
    const Lanes unit = Core::template potential<D>(per_square_ * r_squared);
    if constexpr (D == 2) return potential_scale_ + unit;
    if constexpr (D == 3) return potential_scale_ * unit;
  }

 private:
  double size_, per_square_, per_power_, potential_scale_;
};

template <int D>
[[gnu::always_inline]] inline Lanes square_of(const std::array<Lanes, D>& x) {
  if constexpr (D == 2) return x[0] * x[0] + x[1] * x[1];
  if constexpr (D == 3) return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}

}  // namespace mote
