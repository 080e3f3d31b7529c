#pragma once

#include <span>
#include <vector>

#include "mote/exact/cole_hopf.hpp"

namespace mote {

/// A particle of the gas: where it is, and how it is stretched.
struct FluidParticle {
  double position;     ///< X
  double log_stretch;  ///< ln J, the logarithm of its length over that before it was followed
};

enum class Direction { forwards, backwards };

/// Follows particles from time 0 to `time` > 0, or backwards, through
///   dX/dt = u(X, t),   d ln J/dt = u_x(X, t).
/// The steps are in s = sqrt(t), in which a kink or a jump of the start spreads smoothly, by the
/// method of Bulirsch and Stoer to 1e-14 of the motion's length a step: X is good to some 1e-13 of
/// it and ln J to 1e-12, less what rounding in u_x adds. Fehlberg's 7(8) would not do: for a
/// particle at rest ln J is an integral over time, and its estimate of the error is then 0.
///
/// Backwards, an error grows as the gas was compressed: where that is C, the start is known to
/// 1e-13 C. What the paths reach must be covered.
std::vector<FluidParticle> followed(const ColeHopf& motion, std::span<const double> positions,
                                    double time, Direction direction);

}  // namespace mote
