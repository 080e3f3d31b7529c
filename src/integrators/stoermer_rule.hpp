#pragma once

#include <span>
#include <vector>

#include "mote/integrators/hermite.hpp"
#include "mote/integrators/system.hpp"

namespace mote {

/// Where a system that falls freely is: places, velocities and accelerations of all its parts.
struct FallingState {
  double time = 0;
  Row place, velocity, acceleration;
};

/// The state that a system is in, whose accelerations are evaluated unless it has them.
FallingState falling_state(System& system, double time);

/// A step in equal small steps by Stoermer's rule, whose errors go by even powers of the small one
/// (Hairer, Norsett & Wanner 1993, (II.14.32)): with h = step/n,
///   v_1/2 = v_0 + h/2 f_0,   x_i+1 = x_i + h v_i+1/2,   v_i+1/2 = v_i-1/2 + h f_i,
///   v_n = v_n-1/2 + h/2 f_n.
struct StoermerResult {
  int steps = 0;
  Row change, middle_change;      ///< of places, then velocities: at the end, and half way there
  std::vector<Row> acceleration;  ///< f_0, ..., f_n
};

/// `steps` is even. Leaves the system somewhere near the end of the step.
StoermerResult stoermer_rule(System& system, const FallingState& start, double step, int steps);

/// A path between the ends of a step that was extrapolated from these results: the polynomial
/// through both ends, to their accelerations, and through the middle, with derivatives there from
/// extrapolated central differences of the accelerations, each from the results that have enough
/// of them (as in Hairer, Norsett & Wanner 1993, II.9 and II.14). With k results its error is of
/// order 2k + 1 in the step, as that of the step is.
class ExtrapolatedPath {
 public:
  ExtrapolatedPath(const FallingState& start, const FallingState& end, double step,
                   std::span<const StoermerResult> results);

  /// Places and velocities after a part of the step.
  Interpolated at(double part) const;

 private:
  std::vector<KnownNode> nodes_;  ///< at times from the start on
};

}  // namespace mote
