#pragma once

#include <chrono>
#include <cstdint>

namespace mote {

/// Tells how far a run is: a bar with the time left on a terminal, plain lines in a pipe.
class Progress {
 public:
  enum class Style { quiet, lines, bar };

  /// A bar if standard output is a terminal, else lines.
  static Style style_of_output();

  /// Of a run from `start` to `end`.
  Progress(Style style, double start, double end);

  /// After a step; draws the bar at most ten times a second.
  void step_done(double time);
  /// After a snapshot; prints a line.
  void snapshot_done(std::int64_t step, double time);
  void end();

 private:
  double seconds() const;
  double seconds_left(double time) const;
  int percent(double time) const;

  Style style_;
  double first_, end_;
  std::chrono::steady_clock::time_point started_;
  double last_drawn_ = -1;
};

}  // namespace mote
