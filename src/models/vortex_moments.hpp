#pragma once

#include <span>

#include "mote/particles/vector.hpp"

namespace mote {

/// Sums over vortices in the plane.
struct VortexMoments {
  double circulation = 0;               ///< sum of Gamma
  double magnitude = 0;                 ///< of |Gamma|
  Vec<2> first = Vec<2>::Zero();        ///< of Gamma x
  double first_magnitude = 0;           ///< of |Gamma| |x|
  Mat<2> second = Mat<2>::Zero();       ///< of Gamma x x^T
  Mat<2> second_rate = Mat<2>::Zero();  ///< of Gamma (u x^T + x u^T)

  Vec<2> centre() const { return first / circulation; }
  /// The second moments about the centre, over the circulation.
  Mat<2> spread() const;
  /// Whether they are spread evenly in all directions, to a thousandth.
  bool is_round() const;
  /// The direction in which vortices are spread furthest, from -pi/2 to pi/2, and the rate at which
  /// the velocities turn it. What is round has none: 0.
  double axis() const;
  double axis_rate() const;
};

/// `velocity` may be empty; then there is no `second_rate`.
VortexMoments vortex_moments(std::span<const double> position, std::span<const double> circulation,
                             std::span<const double> velocity);

}  // namespace mote
