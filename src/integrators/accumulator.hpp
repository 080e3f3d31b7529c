#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "mote/integrators/elementwise.hpp"
#include "mote/integrators/system.hpp"
#include "mote/particles/compensated_sum.hpp"

namespace mote {

/// Adds rates to values over many steps and keeps what rounding loses at each addition for the
/// next one, so that the error does not grow with the number of steps.
class Accumulator {
 public:
  /// value += step * rate, for every part.
  void advance(std::span<const Evolving> parts, double step) {
    lost_.resize(parts.size());
    for (std::size_t part = 0; part < parts.size(); ++part)
      add(parts[part].value, parts[part].rate, step, lost_[part]);
  }

  /// The same with what rounding loses lost: no more memory, and on all threads.
  static void advance_plainly(std::span<const Evolving> parts, double step) {
    for (const Evolving& part : parts)
      for_each_element(part.value.size(), [&](auto i) { part.value[i] += step * part.rate[i]; });
  }

  void forget() {
    for (auto& lost : lost_) lost.assign(lost.size(), 0);
  }

  /// What was lost so far, a list for every part.
  const std::vector<std::vector<double>>& lost() const { return lost_; }
  void recall(std::vector<std::vector<double>> lost) { lost_ = std::move(lost); }

 private:
  static void add(std::span<double> value, std::span<const double> rate, double step,
                  std::vector<double>& lost) {
    lost.resize(value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
      add_compensated(step * rate[i], value[i], lost[i]);
  }

  std::vector<std::vector<double>> lost_;
};

}  // namespace mote
