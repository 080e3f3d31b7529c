#include "mote/app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace mote {

Progress::Style Progress::style_of_output() {
  return isatty(STDOUT_FILENO) != 0 ? Style::bar : Style::lines;
}

Progress::Progress(Style style, std::int64_t total_steps, std::int64_t first_step)
    : style_(style),
      total_(total_steps),
      first_(first_step),
      start_(std::chrono::steady_clock::now()) {}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Progress::seconds_left(std::int64_t step) const {
  const auto done = static_cast<double>(step - first_);
  return done > 0 ? seconds() / done * static_cast<double>(total_ - step) : 0;
}

void Progress::step_done(std::int64_t step, double time) {
  if (style_ != Style::bar || seconds() < last_drawn_ + 0.1) return;
  last_drawn_ = seconds();
  constexpr std::int64_t width = 40;
  const std::int64_t filled = width * step / total_;
  fmt::print("\r[{:=<{}}{: <{}}] {:3} %  t = {:<10.4g} {:.0f} s left  ", "", filled, "",
             width - filled, 100 * step / total_, time, seconds_left(step));
  std::fflush(stdout);
}

void Progress::snapshot_done(std::int64_t step, double time) {
  if (style_ != Style::lines) return;
  fmt::print("t = {:<10.6g} step {:<10} {:3} %  {:.0f} s left\n", time, step, 100 * step / total_,
             seconds_left(step));
  std::fflush(stdout);
}

void Progress::end() {
  if (style_ == Style::bar && last_drawn_ >= 0) fmt::print("\r{:<90}\r", "");
}

}  // namespace mote
