#pragma once

#include <cstdint>
#include <cstring>

#include "mote/operators/cores/polynomial.hpp"
#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// Elementary functions of eight numbers at a time, in basic operations alone: the same bits on
/// every instruction set and with every mathematics library. Errors are a few units of rounding.

using LaneBits = std::experimental::fixed_size_simd<std::int64_t, lane_count>;

/// The same bits as numbers of another kind.
template <class To, class From>
[[gnu::always_inline]] inline To same_bits(const From& from) {
  typename From::value_type before[lane_count];
  typename To::value_type after[lane_count];
  static_assert(sizeof before == sizeof after);
  from.copy_to(before, std::experimental::element_aligned);
  std::memcpy(after, before, sizeof after);
  return {after, std::experimental::element_aligned};
}
[[gnu::always_inline]] inline LaneBits bits_of(const Lanes& x) { return same_bits<LaneBits>(x); }
[[gnu::always_inline]] inline Lanes lanes_of(const LaneBits& x) { return same_bits<Lanes>(x); }

/// The numbers, but no more, or no less, than the bound. (min and max of the library are calls.)
[[gnu::always_inline]] inline Lanes at_most(double bound, Lanes x) {
  where(x > bound, x) = bound;
  return x;
}
[[gnu::always_inline]] inline Lanes at_least(double bound, Lanes x) {
  where(x < bound, x) = bound;
  return x;
}

namespace lane_constants {
inline constexpr double to_integer = 0x1.8p52;  ///< added, it leaves a whole number in the low bits
inline constexpr std::int64_t one = 0x3ff0000000000000;  ///< the bits of 1
inline constexpr std::int64_t root_of_half = 0x3fe6a09e667f3bcd;
inline constexpr double log2_e = 1.4426950408889634;
// ln 2 in two parts, the first with room for a factor of 11 bits.
inline constexpr double ln_2_high = 0x1.62e42feep-1, ln_2_low = 0x1.a39ef35793c76p-33;
inline constexpr double half_ln_2 = 0.35;  ///< and a little, for rounding

/// (e^r - 1)/r in powers of r = half_ln_2 z.
inline constexpr auto exponential = in_powers_of(half_ln_2, chebyshev_fit<11>([](long double z) {
                                                   long double term = 1, sum = 1;
                                                   for (int k = 2; k < 25; ++k)
                                                     sum += term *= half_ln_2 * z / k;
                                                   return sum;
                                                 }));

/// 2 (artanh(s)/s - 1)/s^2 for s^2 = (z + 1) half_s_squared.
inline constexpr double half_s_squared = 0.01475;
inline constexpr auto logarithm = chebyshev_fit<9>([](long double z) {
  const long double s_squared = (z + 1) * half_s_squared;
  long double sum = 0;
  for (int k = 30; k >= 1; --k) sum = sum * s_squared + 2.0L / (2 * k + 1);
  return sum;
});
}  // namespace lane_constants

/// e^x in two parts: `scale`, a power of 2, and e^x - scale.
struct ExponentialParts {
  Lanes scale, rest;
};

/// For |x| <= 700: x = n ln 2 + r, e^x = 2^n + 2^n (e^r - 1).
[[gnu::always_inline]] inline ExponentialParts exponential_parts(const Lanes& x) {
  using namespace lane_constants;
  const Lanes shifted = x * log2_e + to_integer;
  const Lanes n = shifted - to_integer;
  const Lanes r = (x - n * ln_2_high) - n * ln_2_low;
  const Lanes scale = lanes_of((bits_of(shifted) << 52) + one);
  return {scale, scale * (r * polynomial(lane_constants::exponential, r))};
}

/// e^x for |x| <= 700.
[[gnu::always_inline]] inline Lanes exponential(const Lanes& x) {
  const auto [scale, rest] = exponential_parts(x);
  return scale + rest;
}

/// 1 - e^-x for 0 <= x <= 700, without loss of digits at small x.
[[gnu::always_inline]] inline Lanes exponential_rise(const Lanes& x) {
  const auto [scale, rest] = exponential_parts(-x);
  return (1 - scale) - rest;
}

/// ln x for positive numbers, not denormal: x = 2^n (1 + f), sqrt(1/2) <= 1 + f < sqrt 2 and
///   ln(1 + f) = 2 artanh(s) = f - (f^2/2 - s (f^2/2 + 2 (artanh(s)/s - 1))),   s = f/(2 + f).
[[gnu::always_inline]] inline Lanes logarithm(const Lanes& x) {
  using namespace lane_constants;
  const LaneBits bits = bits_of(x);
  const LaneBits exponent = (bits - root_of_half) >> 52;
  const Lanes f = lanes_of(bits - (exponent << 52)) - 1;
  const LaneBits shifted = exponent + bits_of(Lanes(to_integer));
  const Lanes n = lanes_of(shifted) - to_integer;
  const Lanes s = f / (2 + f), s_squared = s * s, half_square = 0.5 * f * f;
  const Lanes tail =
      s_squared * polynomial(lane_constants::logarithm, s_squared * (1 / half_s_squared) - 1);
  return n * ln_2_high + (f - (half_square - (s * (half_square + tail) + n * ln_2_low)));
}

}  // namespace mote
