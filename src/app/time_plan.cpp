#include "mote/app/time_plan.hpp"

#include <algorithm>
#include <cmath>

namespace mote {
namespace {

/// Number of pieces of at most `piece` in `whole`; a quotient a rounding above a whole number
/// counts as that number.
std::int64_t pieces(double whole, double piece) {
  constexpr double rounding = 1e-12;
  const double quotient = whole / piece * (1 - rounding);
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(quotient)));
}

}  // namespace

TimePlan::TimePlan(double step, double every, double end)
    : step_(step), every_(every), end_(end), frames_(pieces(end, every)) {}

double TimePlan::time_of_frame(std::int64_t frame) const {
  return frame == frames_ ? end_ : static_cast<double>(frame) * every_;
}

std::int64_t TimePlan::steps_to(std::int64_t frame) const {
  // From the interval itself: the difference of two late times has lost digits.
  return pieces(frame < frames_ ? every_ : end_ - time_of_frame(frame - 1), step_);
}

double TimePlan::step_to(std::int64_t frame) const {
  return (time_of_frame(frame) - time_of_frame(frame - 1)) / static_cast<double>(steps_to(frame));
}

double TimePlan::time(std::int64_t frame, std::int64_t step) const {
  if (step == steps_to(frame)) return time_of_frame(frame);
  return time_of_frame(frame - 1) + static_cast<double>(step) * step_to(frame);
}

std::int64_t TimePlan::total_steps() const {
  return (frames_ - 1) * (frames_ > 1 ? steps_to(1) : 0) + steps_to(frames_);
}

}  // namespace mote
