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
  /// value += step * rate for all that drifts, or is kicked.
  void drift(System& system, double step) { drift(system, system.drifted(), step); }
  void kick(System& system, double step) { kick(system, system.kicked(), step); }

  /// The same with rates of the method's own.
  void drift(const System& system, std::span<const Evolving> parts, double step) {
    advance(drift_, system, parts, step);
  }
  void kick(const System& system, std::span<const Evolving> parts, double step) {
    advance(kick_, system, parts, step);
  }

 private:
  static void advance(Accumulator& accumulator, const System& system,
                      std::span<const Evolving> parts, double step) {
    if (system.compensates())
      accumulator.advance(parts, step);
    else
      Accumulator::advance_plainly(parts, step);
  }

  Accumulator drift_, kick_;
};

}  // namespace mote
