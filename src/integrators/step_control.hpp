#pragma once

#include <algorithm>
#include <cmath>

namespace mote {

/// Chooses the next step by the errors of the last two, each in units of what is tolerated: the
/// proportional-integral controller of Gustafsson (1991), with the constants of Hairer, Norsett and
/// Wanner (1993), section IV.2 of volume II.
class StepControl {
 public:
  /// `power`: of the step that the error goes with.
  explicit StepControl(int power) : power_(power) {}

  /// The step that follows one whose error is at most 1.
  double after_accepted(double step, double error) {
    const double factor =
        0.9 * std::pow(error, -0.7 / power_) * std::pow(previous_error_, 0.4 / power_);
    previous_error_ = std::max(error, smallest_error);
    return step * std::clamp(factor, 0.2, 6.0);
  }

  /// The shorter step that is tried instead of one whose error is beyond 1, or not a number.
  double after_rejected(double step, double error) const {
    const double factor = 0.9 * std::pow(error, -1.0 / power_);
    return step * (factor > 0.1 ? factor : 0.1);
  }

  double previous_error() const { return previous_error_; }
  void recall(double previous_error) { previous_error_ = previous_error; }

 private:
  static constexpr double smallest_error = 1e-4;

  int power_;
  double previous_error_ = smallest_error;
};

}  // namespace mote
