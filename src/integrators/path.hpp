#pragma once

#include <span>
#include <vector>

#include "mote/integrators/system.hpp"

namespace mote {

/// A path of a system between the ends of steps, through values and derivatives there, whatever
/// method took the steps: dense output for methods that have none of their own. For systems that
/// fall freely: what is kicked moves as the derivative of what drifts.
class Path {
 public:
  virtual ~Path() = default;

  /// Takes the state that the system is in at `time` as the next node.
  virtual void add_node(System& system, double time) = 0;

  /// Puts the system's values where the path is at `time`, between the last two nodes.
  virtual void go_to(System& system, double time) const = 0;

  /// All nodes that the path may still depend on, for a restart.
  virtual std::vector<double> memory() const = 0;
  virtual void recall(std::span<const double> memory) = 0;
};

}  // namespace mote
