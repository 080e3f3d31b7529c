#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "mote/integrators/packs.hpp"

namespace mote {

/// Gravity of so few point masses that the way to a sum for many takes longer than their sum: the
/// bodies are the lanes of packs. A body does nothing to one on its own place.
namespace few_bodies {

inline constexpr std::size_t most = 64;

/// 1/r^D, and nothing at r = 0.
template <int D>
[[gnu::always_inline]] inline Pack influence(const Pack& square) {
  const Pack inverse = square > 0 ? 1 / square : Pack{};
  return D == 2 ? inverse : inverse * root(inverse);
}

/// Up to eight bodies, each a lane. Every one is paired with the next but `shift` of the ring that
/// they form, for all shifts up to half around.
template <int D, std::size_t N>
class Ring {
 public:
  static void accelerate(double constant, const double* mass, const double* place, double* result) {
    const Pack pull = constant * taken<1>(mass, all);
    std::array<Pack, D> x, sum{};
    for (std::size_t d = 0; d < D; ++d) x[d] = taken<D>(place + d, all);
    [&]<std::size_t... Before>(std::index_sequence<Before...>) {
      (add<Before + 1>(pull, x, sum), ...);
    }
    (std::make_index_sequence<N / 2>());
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t d = 0; d < D; ++d) result[D * i + d] = sum[d][i];
  }

 private:
  static constexpr auto all = std::make_index_sequence<pack_size>();

  template <std::size_t Stride, std::size_t... Lane>
  [[gnu::always_inline]] static Pack taken(const double* from, std::index_sequence<Lane...>) {
    return Pack{(Lane < N ? from[Stride * Lane] : 0.0)...};
  }

  /// The lanes of the ring, each moved on by so many places.
  template <std::size_t By, std::size_t... Lane>
  [[gnu::always_inline]] static Pack turned(const Pack& pack, std::index_sequence<Lane...>) {
    return __builtin_shufflevector(pack, pack, (Lane < N ? (Lane + By) % N : Lane)...);
  }

  template <std::size_t Shift>
  [[gnu::always_inline]] static void add(const Pack& pull, const std::array<Pack, D>& x,
                                         std::array<Pack, D>& sum) {
    std::array<Pack, D> apart;
    Pack square{};
    for (std::size_t d = 0; d < D; ++d) {
      apart[d] = turned<Shift>(x[d], all) - x[d];
      square += apart[d] * apart[d];
    }
    const Pack factor = influence<D>(square), other = turned<Shift>(pull, all) * factor;
    for (std::size_t d = 0; d < D; ++d) {
      sum[d] += other * apart[d];
      // Half around, a pair stands in two lanes.
      if (2 * Shift != N) sum[d] -= turned<N - Shift>(pull * factor * apart[d], all);
    }
  }
};

/// More bodies: packs of them feel one after another.
template <int D>
void accelerate_packs(double constant, std::span<const double> mass, const double* place,
                      double* result) {
  constexpr std::size_t most_packs = most / pack_size;
  std::array<std::array<Pack, most_packs>, D> x{};
  const std::size_t count = mass.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t d = 0; d < D; ++d) x[d][i / pack_size][i % pack_size] = place[D * i + d];
  for (std::size_t first = 0; first < count; first += pack_size) {
    const std::size_t p = first / pack_size;
    std::array<Pack, D> sum{};
    for (std::size_t j = 0; j < count; ++j) {
      std::array<Pack, D> apart;
      Pack square{};
      for (std::size_t d = 0; d < D; ++d) {
        apart[d] = place[D * j + d] - x[d][p];
        square += apart[d] * apart[d];
      }
      const Pack factor = (constant * mass[j]) * influence<D>(square);
      for (std::size_t d = 0; d < D; ++d) sum[d] += factor * apart[d];
    }
    for (std::size_t i = first; i < std::min(count, first + pack_size); ++i)
      for (std::size_t d = 0; d < D; ++d) result[D * i + d] = sum[d][i - first];
  }
}

/// Accelerations of up to `most` bodies, D numbers each.
template <int D>
void accelerate(double constant, std::span<const double> mass, std::span<const double> place,
                std::span<double> result) {
  const auto ring = [&]<std::size_t N>() {
    Ring<D, N>::accelerate(constant, mass.data(), place.data(), result.data());
  };
  switch (mass.size()) {
    case 1:
      return ring.template operator()<1>();
    case 2:
      return ring.template operator()<2>();
    case 3:
      return ring.template operator()<3>();
    case 4:
      return ring.template operator()<4>();
    case 5:
      return ring.template operator()<5>();
    case 6:
      return ring.template operator()<6>();
    case 7:
      return ring.template operator()<7>();
    case 8:
      return ring.template operator()<8>();
    default:
      accelerate_packs<D>(constant, mass, place.data(), result.data());
  }
}

}  // namespace few_bodies
}  // namespace mote
