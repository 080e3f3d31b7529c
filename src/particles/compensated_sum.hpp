#pragma once

namespace mote {

/// A sum of many terms that keeps what rounding loses at each addition for the next one (Kahan
/// 1965), so that its error does not grow with their number.
class CompensatedSum {
 public:
  CompensatedSum() = default;
  explicit CompensatedSum(double value) : value_(value) {}

  void add(double term) {
    const double change = term - lost_;
    const double sum = value_ + change;
    lost_ = (sum - value_) - change;
    value_ = sum;
  }

  double value() const { return value_; }
  /// What it lacks to this number.
  double lacks(double whole) const { return (whole - value_) + lost_; }

 private:
  double value_ = 0;
  double lost_ = 0;  ///< what `value_` has too much
};

}  // namespace mote
