#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mote {

/// How many terms the expansions of two nodes need, looked up by how near they are to each other:
/// by the ratio r = a/(d - b) of balls of radii a >= b, their centres d apart, with which the terms
/// fall.
class DegreeByRatio {
 public:
  /// r^terms < `tolerance` up to the ratio `largest`, or as far as `most_terms` go; beyond it nodes
  /// are too near.
  DegreeByRatio(double tolerance, double largest, int most_terms) {
    const auto terms = [&](double ratio) {
      return static_cast<int>(std::ceil(std::log(tolerance) / std::log(ratio)));
    };
    degree_ = std::min(terms(largest), most_terms);
    degrees_.assign(steps + 1, static_cast<std::uint8_t>(degree_ + 1));
    for (int step = 0; step + 1 <= steps * largest; ++step)
      if (const int needed = terms((step + 1.0) / steps); needed <= degree_)
        degrees_[static_cast<std::size_t>(step)] = static_cast<std::uint8_t>(std::max(2, needed));
  }

  /// The largest there is.
  int degree() const { return degree_; }
  /// Of balls of radii a and b, d apart; more than `degree()` if they are too near.
  int operator()(double a, double b, double d) const {
    const double gap = d - a - b, larger = std::max(a, b);
    if (gap <= 0) return degree_ + 1;
    return degrees_[static_cast<std::size_t>(larger / (gap + larger) * steps)];
  }

 private:
  static constexpr int steps = 512;

  int degree_ = 0;
  std::vector<std::uint8_t> degrees_;
};

}  // namespace mote
