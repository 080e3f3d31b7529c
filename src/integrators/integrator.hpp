#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mote/integrators/accumulator.hpp"
#include "mote/integrators/system.hpp"

namespace mote {

/// A method that takes steps.
///
/// Most methods keep nothing between steps but work arrays and what rounding lost, which they
/// forget at every snapshot: so a restart needs no more than the system's values. What else a
/// method keeps is its `memory`, which goes into snapshots.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// What the system lacks that the method needs, to be read after "it needs"; empty if nothing.
  virtual std::string missing_in(System& /*system*/) const { return {}; }

  /// From `time` to `time + step`.
  virtual void advance_one_step(System& system, double time, double step) = 0;

  /// From `time` on by a step that the method chooses, `longest` at most, and returns its length. A
  /// method that does not control its error takes all of it.
  virtual double advance(System& system, double time, double longest) {
    advance_one_step(system, time, longest);
    return longest;
  }

  /// Whether `advance` chooses its steps, so that `longest` may be infinite, and the error that a
  /// step may then make, relative to the largest value of its kind.
  virtual bool chooses_steps() const { return false; }
  virtual void tolerate(double /*error*/) {}

  /// Whether the method has a path of its own between the ends of its last step, and puts the
  /// system's values where they were after this part of that step, between 0 and 1.
  virtual bool has_path() const { return false; }
  virtual void go_along_path(System& /*system*/, double /*part*/) {}

  /// Evaluations of forces that the method did itself, and not the system.
  virtual std::int64_t own_evaluations() const { return 0; }

  /// Whether a step of another length than the last one is a start from nothing.
  virtual bool wants_equal_steps() const { return false; }

  /// What the next step depends on beside the system's values; empty before the first step, and
  /// for methods that start afresh at every step. `recall` takes it back.
  virtual std::vector<double> memory() const { return {}; }
  virtual void recall(std::span<const double> /*memory*/) {}

  /// To be called at every snapshot, and so before the first step, unless steps go on as if there
  /// was none: then a restart needs `rounding` beside the memory.
  void forget_rounding() {
    drift_.forget();
    kick_.forget();
  }
  std::array<std::vector<std::vector<double>>, 2> rounding() const {
    return {drift_.lost(), kick_.lost()};
  }
  void recall_rounding(std::array<std::vector<std::vector<double>>, 2> lost) {
    drift_.recall(std::move(lost[0]));
    kick_.recall(std::move(lost[1]));
  }

 protected:
  /// value += step * rate for all that drifts, or is kicked.
  void drift(System& system, double step) { drift(system, system.drifted(), step); }
  void kick(System& system, double step) { kick(system, system.kicked(), step); }

  /// The same with rates of the method's own.
  void drift(const System& system, std::span<const Evolving> parts, double step) {
    add(drift_, system, parts, step);
  }
  void kick(const System& system, std::span<const Evolving> parts, double step) {
    add(kick_, system, parts, step);
  }

 private:
  static void add(Accumulator& accumulator, const System& system, std::span<const Evolving> parts,
                  double step) {
    if (system.compensates())
      accumulator.advance(parts, step);
    else
      Accumulator::advance_plainly(parts, step);
  }

  Accumulator drift_, kick_;
};

}  // namespace mote
