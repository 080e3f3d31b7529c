#pragma once

#include <array>
#include <cmath>

#include "mote/operators/cores/core.hpp"
#include "mote/operators/cores/lane_functions.hpp"
#include "mote/operators/differential/inverse_root.hpp"

namespace mote {

/// How the field of one source depends on the distance, for eight targets at a time:
///   influence        q/r^D,
///   influence_slope  (1/r) d(q/r^D)/dr,
///   potential        2D: ln r, 3D: 1/r, or what takes their place within a core,
///   reach            the distance beyond which it is a point's to within a tolerance.
/// Divisions and roots take long. What can be begun of them a while before it is used is
///   ahead(r^2 of two sources)            which the pair loop keeps until
///   at(ahead, which of the two, r^2)     gives the functions above.

/// Potential and influence of one strength: together they may cost less than each alone.
struct BothFunctions {
  Lanes potential, influence;
};

/// A point, q = 1. On its own place it does nothing.
template <int D>
struct PointShape;

template <>
struct PointShape<2> {
  static constexpr int dimension = 2;
  static constexpr bool has_size = false;
  static PointShape of_size(double) { return {}; }
  static double reach(double) { return 0; }

  struct Ahead {
    std::array<Lanes, 2> inverse_square;
  };
  struct At {
    Lanes r_squared, inverse_square;

    [[gnu::always_inline]] Lanes influence() const { return inverse_square; }
    [[gnu::always_inline]] Lanes influence_slope() const {
      return -2 * inverse_square * inverse_square;
    }
    [[gnu::always_inline]] Lanes potential() const {
      Lanes result = 0.5 * logarithm(r_squared);
      where(r_squared == 0, result) = 0;
      return result;
    }
    [[gnu::always_inline]] BothFunctions both(double strength) const {
      return {strength * potential(), strength * influence()};
    }
  };

  [[gnu::always_inline]] static Ahead ahead(const std::array<Lanes, 2>& r_squared) {
    return {{inverse_or_zero(r_squared[0]), inverse_or_zero(r_squared[1])}};
  }
  [[gnu::always_inline]] static At at(const Ahead& ahead, std::size_t which,
                                      const Lanes& r_squared) {
    return {r_squared, ahead.inverse_square[which]};
  }
};

template <>
struct PointShape<3> {
  static constexpr int dimension = 3;
  static constexpr bool has_size = false;
  static PointShape of_size(double) { return {}; }
  static double reach(double) { return 0; }

  using Ahead = RootEstimates;
  struct At {
    InverseRoot root;

    [[gnu::always_inline]] Lanes influence() const { return root.cube(); }
    [[gnu::always_inline]] Lanes influence_slope() const {
      return -3 * root.cube() * root.square();
    }
    [[gnu::always_inline]] Lanes potential() const { return root.value(); }
    [[gnu::always_inline]] BothFunctions both(double strength) const {
      const Lanes inverse = root.value(), potential = strength * inverse;
      return {potential, potential * (inverse * inverse)};
    }
  };

  [[gnu::always_inline]] static Ahead ahead(const std::array<Lanes, 2>& r_squared) {
    return RootEstimates(r_squared);
  }
  [[gnu::always_inline]] static At at(const Ahead& ahead, std::size_t which, const Lanes&) {
    return {ahead.refined(which)};
  }
};

/// A blob of this core and size.
template <int D, VortexCore Core>
class BlobShape {
 public:
  static constexpr int dimension = D;
  static constexpr bool has_size = true;
  static BlobShape of_size(double size) { return BlobShape(size); }

  explicit BlobShape(double size)
      : size_(size),
        per_square_(1 / (size * size)),
        per_power_(D == 2 ? per_square_ : per_square_ / size),
        potential_scale_(D == 2 ? std::log(size) : 1 / size) {}

  double reach(double tolerance) const { return size_ * Core::template reach<D>(tolerance); }

  struct Ahead {};
  struct At {
    const BlobShape& blob;
    Lanes rho_squared;

    [[gnu::always_inline]] Lanes influence() const {
      return blob.per_power_ * Core::template influence<D>(rho_squared);
    }
    [[gnu::always_inline]] Lanes influence_slope() const {
      return blob.per_power_ * blob.per_square_ * Core::template influence_slope<D>(rho_squared);
    }
    [[gnu::always_inline]] Lanes potential() const {
      const Lanes unit = Core::template potential<D>(rho_squared);
      if constexpr (D == 2) return blob.potential_scale_ + unit;
      if constexpr (D == 3) return blob.potential_scale_ * unit;
    }
    [[gnu::always_inline]] BothFunctions both(double strength) const {
      return {strength * potential(), strength * influence()};
    }
  };

  [[gnu::always_inline]] static Ahead ahead(const std::array<Lanes, 2>&) { return {}; }
  [[gnu::always_inline]] At at(const Ahead&, std::size_t, const Lanes& r_squared) const {
    return {*this, per_square_ * r_squared};
  }

 private:
  double size_, per_square_, per_power_, potential_scale_;
};

/// The functions of a shape at one distance.
template <class Shape>
[[gnu::always_inline]] inline typename Shape::At at_distance(const Shape& shape, double r) {
  const Lanes r_squared = r * r;
  return shape.at(shape.ahead({r_squared, r_squared}), 0, r_squared);
}

template <int D>
[[gnu::always_inline]] inline Lanes square_of(const std::array<Lanes, D>& x) {
  if constexpr (D == 2) return fused(x[0], x[0], x[1] * x[1]);
  if constexpr (D == 3) return fused(x[0], x[0], fused(x[1], x[1], x[2] * x[2]));
}

}  // namespace mote
