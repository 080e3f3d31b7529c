#include "mote/app/time_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/particles/failure.hpp"

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

bool TimePlan::has_frame_at(double time) const {
  const auto frame = static_cast<std::int64_t>(std::llround(time / every_));
  return time == end_ || (frame <= frames_ && time == time_of_frame(frame));
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

Step TimePlan::equal_step(std::int64_t frame, std::int64_t number) const {
  return {step_to(frame), time(frame, number)};
}

void TimePlan::refuse_nothing(double longest) const {
  constexpr double shortest = 1e-9;
  if (!(longest >= shortest * every_))
    throw NumericalFailure(
        fmt::format("the state allows no step beyond {:.3g}, less than {:.0e} of the time between "
                    "two snapshots",
                    longest, shortest),
        {},
        "particles have become so fast, or so close, that the run cannot go on; a smaller courant "
        "number may keep them apart");
}

Step TimePlan::free_step(std::int64_t number) const {
  return {step_, static_cast<double>(number) * step_};
}

Step TimePlan::free_step_within(double time, double longest) const {
  refuse_nothing(longest);
  const double length = std::min(longest, step_);
  return {length, time + length};
}

Step TimePlan::step_within(std::int64_t frame, double time, double longest) const {
  refuse_nothing(longest);
  const double target = time_of_frame(frame), left = target - time;
  longest = std::min(longest, step_);
  if (left <= longest) return {left, target};
  const double length = left < 2 * longest ? left / 2 : longest;
  return {length, time + length};
}

bool TimePlan::passes_tenth(std::int64_t frame, double before, double after) const {
  const double start = time_of_frame(frame - 1), whole = time_of_frame(frame) - start;
  const auto tenth = [&](double time) { return std::floor(10 * ((time - start) / whole)); };
  return tenth(after) > tenth(before);
}

}  // namespace mote
