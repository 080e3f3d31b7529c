#pragma once

#include <cstdint>

namespace mote {

/// Equal steps that hit every snapshot time exactly and are never longer than asked for. Frame k
/// is the snapshot at k * every, the last frame is at the end.
class TimePlan {
 public:
  TimePlan(double step, double every, double end);

  std::int64_t frames() const { return frames_; }
  double time_of_frame(std::int64_t frame) const;
  /// Steps from frame - 1 to frame, and their length.
  std::int64_t steps_to(std::int64_t frame) const;
  double step_to(std::int64_t frame) const;
  /// Time after `step` of the steps to `frame`.
  double time(std::int64_t frame, std::int64_t step) const;
  std::int64_t total_steps() const;

 private:
  double step_, every_, end_;
  std::int64_t frames_;
};

}  // namespace mote
