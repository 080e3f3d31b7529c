#pragma once

#include <functional>

#include "mote/exact/piecewise_chebyshev.hpp"

namespace mote {

/// The velocity of Burgers' equation u_t + u u_x = nu u_xx on the whole line, by the transformation
/// of Cole (1951) and Hopf (1950). With the start u0, its integral P and
///   F(y) = P(y) + (x - y)^2/(2 t),   <f> = int f exp(-F/(2 nu)) dy / int exp(-F/(2 nu)) dy
/// it is
///   u = <u0>,   u_x = (<u0 y> - <u0> <y>)/(2 nu t),
/// for a start with kinks and jumps too: F has none.
///
/// The integrals are Gauss-Legendre sums on panels. Panels are halved where the weight is not
/// resolved and left out where F lies so far above its minimum that the weight is below rounding.
/// F is taken relative to its minimum: nothing overflows at any nu > 0. What is left is rounding,
/// as if x and u0 were off by a few units in their last place: u is good to 1e-15 of the largest
/// |u0|, and to 1e-16 |x u_x| where a layer is so thin that this is more; u_x to 1e-15 of the
/// steepest slope, and to 1e-16 |u0|/sqrt(2 nu t) soon after the start.
class ColeHopf {
 public:
  /// `start` as PiecewiseChebyshev takes it; [lower, upper] is where most places lie.
  ColeHopf(std::function<double(double)> start, double lower, double upper, double viscosity);

  /// Prepares for all places between these and all times up to this. Throws std::domain_error if
  /// the start is needed too far away.
  void cover(double lower, double upper, double time);

  /// The largest |u0| of what is covered.
  double fastest() const { return start_.largest(); }
  /// Of the interval where most places lie.
  double length() const { return length_; }

  struct Motion {
    double velocity, slope;  ///< u and u_x
  };
  /// At a place and a time > 0 that are covered.
  Motion operator()(double place, double time) const;

 private:
  double reach(double time) const;

  PiecewiseChebyshev start_;
  double length_, viscosity_;
};

}  // namespace mote
