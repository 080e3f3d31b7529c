#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "mote/integrators/system.hpp"

// How packs are handed over depends on the instruction set. Only functions that are compiled
// together do so.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace mote {

/// Eight numbers side by side. Operations on them are those on the numbers, so that the bits of a
/// result do not depend on the instruction set.
using Pack [[gnu::vector_size(64)]] = double;
inline constexpr std::size_t pack_size = 8;

[[gnu::always_inline]] inline Pack magnitude(const Pack& x) { return x < 0 ? -x : x; }
[[gnu::always_inline]] inline Pack larger(const Pack& x, const Pack& y) { return x > y ? x : y; }

[[gnu::always_inline]] inline Pack root(const Pack& x) {
  Pack result;
  for (std::size_t k = 0; k < pack_size; ++k) result[k] = std::sqrt(x[k]);
  return result;
}

inline double largest_of(const Pack& pack) {
  const double low = std::max(std::max(pack[0], pack[1]), std::max(pack[2], pack[3]));
  const double high = std::max(std::max(pack[4], pack[5]), std::max(pack[6], pack[7]));
  return std::max(low, high);
}

/// The numbers of all parts of a system one after the other, in whole packs; zeros fill the last.
class PackedColumn {
 public:
  void resize(std::size_t count) { packs_.assign((count + pack_size - 1) / pack_size, Pack{}); }
  std::size_t packs() const { return packs_.size(); }

  Pack& operator[](std::size_t pack) { return packs_[pack]; }
  const Pack& operator[](std::size_t pack) const { return packs_[pack]; }

  double* begin() { return reinterpret_cast<double*>(packs_.data()); }
  const double* begin() const { return reinterpret_cast<const double*>(packs_.data()); }

  void take_values(std::span<const Evolving> parts) {
    double* to = begin();
    for (const Evolving& part : parts) to = std::copy(part.value.begin(), part.value.end(), to);
  }
  void take_rates(std::span<const Evolving> parts) {
    double* to = begin();
    for (const Evolving& part : parts) to = std::copy(part.rate.begin(), part.rate.end(), to);
  }
  void give_values(std::span<const Evolving> parts) const {
    const double* from = begin();
    for (const Evolving& part : parts) {
      std::copy_n(from, part.value.size(), part.value.begin());
      from += part.value.size();
    }
  }
  bool has_values(std::span<const Evolving> parts) const {
    const double* from = begin();
    for (const Evolving& part : parts) {
      if (!std::equal(part.value.begin(), part.value.end(), from)) return false;
      from += part.value.size();
    }
    return true;
  }

 private:
  std::vector<Pack> packs_;
};

}  // namespace mote
