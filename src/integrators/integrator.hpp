#pragma once

#include "mote/integrators/accumulator.hpp"
#include "mote/integrators/system.hpp"

namespace mote {

/// A method that takes steps. Between steps it keeps nothing but work arrays and what rounding
/// lost, which it forgets at every snapshot: so a restart needs no more than the system's values.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// From `time` to `time + step`.
  virtual void advance_one_step(System& system, double time, double step) = 0;

  /// To be called at every snapshot, and so before the first step.
  void forget_rounding() {
    drift_.forget();
    kick_.forget();
  }

 protected:
  void drift(std::span<const Evolving> parts, double step) { drift_.advance(parts, step); }
  void kick(std::span<const Evolving> parts, double step) { kick_.advance(parts, step); }

 private:
  Accumulator drift_, kick_;
};

}  // namespace mote
