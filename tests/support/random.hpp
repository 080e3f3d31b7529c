#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace mote::test {

/// Seeded random numbers, the same on every platform.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [lower, upper).
  double uniform(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

  std::vector<double> uniform(std::size_t count, double lower, double upper) {
    std::vector<double> values(count);
    for (double& value : values) value = uniform(lower, upper);
    return values;
  }

  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mote::test
