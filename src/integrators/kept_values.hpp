#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mote/integrators/system.hpp"

namespace mote {

/// The values of a system's parts at the start of a step, to evaluate elsewhere and come back.
class KeptValues {
 public:
  void keep(std::span<const Evolving> parts) {
    values_.resize(parts.size());
    for (std::size_t part = 0; part < parts.size(); ++part)
      values_[part].assign(parts[part].value.begin(), parts[part].value.end());
  }

  void restore(std::span<const Evolving> parts) const {
    for (std::size_t part = 0; part < parts.size(); ++part)
      std::ranges::copy(values_[part], parts[part].value.begin());
  }

  /// Puts every part at its kept value + step * rate.
  void go_on(std::span<const Evolving> parts, double step) const {
    for (std::size_t part = 0; part < parts.size(); ++part)
      for (std::size_t i = 0; i < values_[part].size(); ++i)
        parts[part].value[i] = values_[part][i] + step * parts[part].rate[i];
  }

 private:
  std::vector<std::vector<double>> values_;
};

}  // namespace mote
