#pragma once

#include <memory>
#include <vector>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/path.hpp"
#include "mote/output/snapshot.hpp"

namespace mote {

/// The way of a system through steps that know nothing of snapshots: it keeps what a restart before
/// the last step needs, and puts the system to any time within that step and back.
class PathCourse {
 public:
  /// Without a path the integrator's own is taken. From `start` on, the state that the system is
  /// in.
  PathCourse(System& system, Integrator& integrator, std::unique_ptr<Path> path,
             const Moment& start);

  /// Goes back to the start of a step, from a snapshot. Throws InputError if it is of another
  /// system.
  void go_back_to(const Restart& restart);

  /// The end of the last step.
  const Moment& node() const { return node_; }

  /// To be called around each step: `advance` takes it, and returns the time at its end.
  template <class Advance>
  void take_step(Advance advance) {
    begin_step();
    end_step(advance());
  }

  /// Puts the system where it is at `time` within the last step, or where that step ended.
  void show(double time);
  void show_node();

  /// The start of the last step.
  const Restart& restart() const { return before_; }

 private:
  void begin_step();
  void end_step(double time);

  System& system_;
  Integrator& integrator_;
  std::unique_ptr<Path> path_;
  Moment node_;
  Restart before_;
  std::vector<double> node_values_;  ///< while the system is elsewhere, else empty
};

}  // namespace mote
