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

  Progress(Style style, std::int64_t total_steps, std::int64_t first_step);

  /// After a step; draws the bar at most ten times a second.
  void step_done(std::int64_t step, double time);
  /// After a snapshot; prints a line.
  void snapshot_done(std::int64_t step, double time);
  void end();

 private:
  double seconds() const;
  double seconds_left(std::int64_t step) const;

  Style style_;
  std::int64_t total_, first_;
  std::chrono::steady_clock::time_point start_;
  double last_drawn_ = -1;
};

}  // namespace mote
