#pragma once

#include <cstdint>

namespace mote {

/// A step: how long it is, and the time at its end.
struct Step {
  double length = 0, end = 0;
};

/// Equal steps that hit every snapshot time exactly and are never longer than asked for. Frame k
/// is the snapshot at k * every, the last frame is at the end. Where the state of the run limits
/// the steps they follow it and hit the snapshot times all the same.
class TimePlan {
 public:
  /// `step` is infinite where the state alone limits the steps.
  TimePlan(double step, double every, double end);

  std::int64_t frames() const { return frames_; }
  /// Time between frames.
  double every() const { return every_; }
  double time_of_frame(std::int64_t frame) const;
  /// Whether a frame is at this time.
  bool has_frame_at(double time) const;
  /// Steps from frame - 1 to frame, and their length.
  std::int64_t steps_to(std::int64_t frame) const;
  double step_to(std::int64_t frame) const;
  /// Time after `step` of the steps to `frame`.
  double time(std::int64_t frame, std::int64_t step) const;
  std::int64_t total_steps() const;

  /// The `number`-th of the equal steps to `frame`.
  Step equal_step(std::int64_t frame, std::int64_t number) const;
  /// The step from `time` on towards `frame` where the state allows none beyond `longest`: what is
  /// left goes in two halves rather than in a long step and a tiny one. Throws NumericalFailure if
  /// `longest` is next to nothing or not a number.
  Step step_within(std::int64_t frame, double time, double longest) const;
  /// Steps that know nothing of frames: the `number`-th of equal ones, and the one from `time` on
  /// where the state allows none beyond `longest`. Throws NumericalFailure as above.
  Step free_step(std::int64_t number) const;
  Step free_step_within(double time, double longest) const;

  /// Whether a tenth of the way to `frame` is passed between these times.
  bool passes_tenth(std::int64_t frame, double before, double after) const;

 private:
  void refuse_nothing(double longest) const;

  double step_, every_, end_;
  std::int64_t frames_;
};

}  // namespace mote
