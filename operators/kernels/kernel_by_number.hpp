#pragma once

#include <functional>

#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// Any kernel, asked for one number at a time. All kernels without formulas for lanes share the
/// pair terms on this one: slower, but compiled once.
class KernelByNumber {
 public:
  template <class Kernel>
  explicit KernelByNumber(const Kernel& kernel)
      : support_(kernel.support()),
        value_([kernel](double q) { return kernel.value(q); }),
        slope_over_q_([kernel](double q) { return kernel.slope_over_q(q); }) {}

  double support() const { return support_; }
  double value(double q) const { return value_(q); }
  double slope_over_q(double q) const { return slope_over_q_(q); }

 private:
  double support_;
  std::function<double(double)> value_, slope_over_q_;
};

}  // namespace mote
