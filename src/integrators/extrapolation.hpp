#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mote/integrators/rows.hpp"

namespace mote {

/// Extrapolation to steps of no length, from results with n_1 < n_2 < ... steps whose errors go by
/// even powers of the step (Aitken & Neville; Hairer, Norsett & Wanner 1993, (II.9.10)):
///   T_j,k+1 = T_j,k + (T_j,k - T_j-1,k)/((n_j/n_j-k)^2 - 1).
class Extrapolation {
 public:
  void add(int steps, Row result) {
    steps_.push_back(steps);
    for (std::size_t k = 0; k < last_.size(); ++k) {
      const double ratio = static_cast<double>(steps) / steps_[steps_.size() - 2 - k];
      Row next = result;
      for (std::size_t i = 0; i < next.size(); ++i)
        next[i] += (result[i] - last_[k][i]) / (ratio * ratio - 1);
      last_[k] = std::exchange(result, std::move(next));
    }
    last_.push_back(std::move(result));
  }

  /// T_jj, and T_j,j-1 (from two results on), whose difference is the latter's error.
  const Row& best() const { return last_.back(); }
  const Row& second_best() const { return last_[last_.size() - 2]; }

 private:
  std::vector<int> steps_;
  std::vector<Row> last_;  ///< T_j1, ..., T_jj
};

}  // namespace mote
