#include "mote/app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace mote {

Progress::Style Progress::style_of_output() {
  return isatty(STDOUT_FILENO) != 0 ? Style::bar : Style::lines;
}

Progress::Progress(Style style, double start, double end)
    : style_(style), first_(start), end_(end), started_(std::chrono::steady_clock::now()) {}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

double Progress::seconds_left(double time) const {
  const double done = time - first_;
  return done > 0 ? seconds() / done * (end_ - time) : 0;
}

/// A whole number of per cent although the quotient is rounded.
int Progress::percent(double time) const { return static_cast<int>(100 * time / end_ + 1e-9); }

void Progress::step_done(double time) {
  if (style_ != Style::bar || seconds() < last_drawn_ + 0.1) return;
  last_drawn_ = seconds();
  constexpr int width = 40;
  const int filled = width * percent(time) / 100;
  fmt::print("\r[{:=<{}}{: <{}}] {:3} %  t = {:<10.4g} {:.0f} s left  ", "", filled, "",
             width - filled, percent(time), time, seconds_left(time));
  std::fflush(stdout);
}

void Progress::snapshot_done(std::int64_t step, double time) {
  if (style_ != Style::lines) return;
  fmt::print("t = {:<10.6g} step {:<10} {:3} %  {:.0f} s left\n", time, step, percent(time),
             seconds_left(time));
  std::fflush(stdout);
}

void Progress::end() {
  if (style_ == Style::bar && last_drawn_ >= 0) fmt::print("\r{:<90}\r", "");
}

}  // namespace mote
