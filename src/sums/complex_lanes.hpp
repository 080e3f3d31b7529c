#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <utility>

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// Calls `body(k)` for k = 0, ..., N - 1 with k known to the compiler, which then keeps arrays of
/// lanes indexed by it in registers.
template <std::size_t N, class Body>
inline void unrolled(Body body) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (body(std::integral_constant<std::size_t, k>()), ...);
  }
  (std::make_index_sequence<N>());
}

inline Lanes load(const double* from) { return Lanes(from, std::experimental::element_aligned); }

inline void store(const Lanes& lanes, double* to) {
  lanes.copy_to(to, std::experimental::element_aligned);
}

/// The first `count` lanes, and 0 behind them.
inline Lanes first_lanes(Lanes lanes, std::size_t count) {
  const Lanes number([](auto lane) { return static_cast<double>(lane); });
  where(number >= static_cast<double>(count), lanes) = 0;
  return lanes;
}

/// Eight complex numbers.
struct ComplexLanes {
  Lanes real, imaginary;

  ComplexLanes& operator*=(const ComplexLanes& b) {
    const Lanes product = real * b.real - imaginary * b.imaginary;
    imaginary = real * b.imaginary + imaginary * b.real;
    real = product;
    return *this;
  }
  ComplexLanes& operator*=(const std::complex<double>& b) {
    return *this *= ComplexLanes{Lanes(b.real()), Lanes(b.imag())};
  }
};

/// first, first z, first z^2, ..., first z^7.
inline ComplexLanes powers(const std::complex<double>& first, const std::complex<double>& z) {
  std::array<double, lane_count> real, imaginary;
  const std::complex<double> z2 = z * z, z4 = z2 * z2;
  const std::array<std::complex<double>, 4> low = {first, first * z, first * z2, first * z * z2};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::complex<double> high = low[k] * z4;
    real[k] = low[k].real();
    imaginary[k] = low[k].imag();
    real[k + 4] = high.real();
    imaginary[k + 4] = high.imag();
  }
  return {load(real.data()), load(imaginary.data())};
}

/// z^8.
inline std::complex<double> eighth_power(const std::complex<double>& z) {
  const std::complex<double> z2 = z * z, z4 = z2 * z2;
  return z4 * z4;
}

/// z^0, z^1, ... from `to` on, `packs` packs of lanes of each part, imaginary ones `stride` behind.
inline void list_powers(const std::complex<double>& z, std::size_t packs, std::size_t stride,
                        double* to) {
  ComplexLanes power = powers(1, z);
  const std::complex<double> step = eighth_power(z);
  for (std::size_t pack = 0; pack < packs; ++pack, power *= step) {
    store(power.real, to + pack * lane_count);
    store(power.imaginary, to + stride + pack * lane_count);
  }
}

}  // namespace mote
