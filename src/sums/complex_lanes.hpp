#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "mote/sums/lane_access.hpp"

namespace mote {

/// Eight complex numbers side by side.
struct ComplexLanes {
  Lanes real = 0, imaginary = 0;

  ComplexLanes() = default;
  ComplexLanes(const Lanes& re, const Lanes& im) : real(re), imaginary(im) {}
  /// The same number eight times.
  explicit ComplexLanes(std::complex<double> number)
      : real(number.real()), imaginary(number.imag()) {}
  /// The first eight of `numbers`; what is missing is 0.
  explicit ComplexLanes(std::span<const std::complex<double>> numbers)
      : real([&](std::size_t k) { return k < numbers.size() ? numbers[k].real() : 0; }),
        imaginary([&](std::size_t k) { return k < numbers.size() ? numbers[k].imag() : 0; }) {}

  ComplexLanes& operator+=(const ComplexLanes& other) {
    real += other.real;
    imaginary += other.imaginary;
    return *this;
  }
  ComplexLanes& operator*=(const ComplexLanes& other) {
    const Lanes product = real * other.real - imaginary * other.imaginary;
    imaginary = real * other.imaginary + imaginary * other.real;
    real = product;
    return *this;
  }
  ComplexLanes& operator*=(const std::complex<double>& other) {
    return *this *= ComplexLanes(other);
  }
  std::complex<double> operator[](std::size_t k) const { return {real[k], imaginary[k]}; }
};

/// Sum of the lanes, in a fixed order.
inline std::complex<double> sum_of(const ComplexLanes& lanes) {
  return {sum_of(lanes.real), sum_of(lanes.imaginary)};
}

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
