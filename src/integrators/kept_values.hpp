#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mote/integrators/elementwise.hpp"
#include "mote/integrators/system.hpp"

namespace mote {

/// The values of a system's parts at the start of a step, to evaluate elsewhere and come back.
class KeptValues {
 public:
  void keep(std::span<const Evolving> parts) {
    values_.resize(parts.size());
    for (std::size_t part = 0; part < parts.size(); ++part) {
      values_[part].resize(parts[part].value.size());
      copy(parts[part].value, values_[part]);
    }
  }

  std::span<const double> values(std::size_t part) const { return values_[part]; }

  void restore(std::span<const Evolving> parts) const {
    for (std::size_t part = 0; part < parts.size(); ++part) copy(values_[part], parts[part].value);
  }

  /// Puts every part at its kept value + step * rate.
  void go_on(std::span<const Evolving> parts, double step) const {
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const std::span<const double> from = values_[part], rate = parts[part].rate;
      const std::span<double> to = parts[part].value;
      for_each_element(from.size(), [=](auto i) { to[i] = from[i] + step * rate[i]; });
    }
  }

 private:
  static void copy(std::span<const double> from, std::span<double> to) {
    for_each_element(from.size(), [=](auto i) { to[i] = from[i]; });
  }

  std::vector<std::vector<double>> values_;
};

}  // namespace mote
