#pragma once

#include <complex>
#include <span>

#include "mote/operators/differential/lanes.hpp"

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
  std::complex<double> operator[](std::size_t k) const { return {real[k], imaginary[k]}; }
};

/// Sum of the lanes, in a fixed order.
inline std::complex<double> sum_of(const ComplexLanes& lanes) {
  return {sum_of(lanes.real), sum_of(lanes.imaginary)};
}

}  // namespace mote
