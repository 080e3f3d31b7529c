#pragma once

namespace mote {

/// Adds a term to a value, and what rounding lost at the additions before it; `lost` is then what
/// this one has added too much (Kahan 1965).
inline void add_compensated(double term, double& value, double& lost) {
  const double change = term - lost;
  const double sum = value + change;
  lost = (sum - value) - change;
  value = sum;
}

/// A sum of many terms that keeps what rounding loses at each addition for the next one, so that
/// its error does not grow with their number.
class CompensatedSum {
 public:
  CompensatedSum() = default;
  explicit CompensatedSum(double value) : value_(value) {}

  void add(double term) { add_compensated(term, value_, lost_); }

  double value() const { return value_; }
  /// What it lacks to this number.
  double lacks(double whole) const { return (whole - value_) + lost_; }

 private:
  double value_ = 0;
  double lost_ = 0;  ///< what `value_` has too much
};

}  // namespace mote
