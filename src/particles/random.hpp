#pragma once

#include <cstdint>

namespace mote {

/// Draw number `counter` of the stream `seed`, uniform in [0, 1): SplitMix64 (Steele, Lea, Flood
/// 2014). Random numbers come by counter, so they depend on the particle and not on the order of
/// work.
constexpr double uniform_random(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed + (counter + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

}  // namespace mote
