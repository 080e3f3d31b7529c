#pragma once

#include "mote/operators/kernels/space_integral.hpp"
#include "mote/options/description.hpp"

namespace mote {

/// The MPS weight that Isshiki (2014), section 4, puts into the sums of SPH:
///   w = alpha (r_e/(r + eps) - 1/(1 + eps/r_e)) for r <= r_e                             (54)
/// with eps << r_e (corrected), as a function of q = r/h, h = r_e. Its derivatives are taken from
/// the singular weight c/r that it stands for:
///   w' = -w/r,   w'' = 2 w/r^2                                                      (48), (50)
/// so it is not a kernel whose slope is the derivative of its value. alpha makes the integral over
/// space 1, (48) corrected.
template <int D>
class SoftenedReciprocal {
 public:
  static constexpr double usual_length = 2;

  SoftenedReciprocal() { normalise(); }

  static constexpr double support() { return 1; }
  double value(double q) const { return q <= 1 ? alpha_ * shape(q) : 0; }
  double slope_over_q(double q) const { return -value(q) / (q * q); }
  double curvature(double q) const { return 2 * value(q) / (q * q); }

  void describe(Description& description) {
    description.number({"epsilon", "softening of the weight, in smoothing lengths"}, epsilon_,
                       {1e-6, 1});
    normalise();
  }

 private:
  double shape(double q) const { return 1 / (q + epsilon_) - 1 / (1 + epsilon_); }
  void normalise() {
    alpha_ = 1 / space_integral<D>([this](double q) { return shape(q); }, support());
  }

  double epsilon_ = 0.01;
  double alpha_ = 1;
};

}  // namespace mote
