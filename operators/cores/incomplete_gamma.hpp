#pragma once

#include <numbers>

#include "mote/operators/cores/lane_functions.hpp"

namespace mote {

/// Incomplete gamma functions of eight numbers at a time. Up to x = gamma_split a polynomial, and
/// beyond it Gamma(a, x) e^x x^(1-a), which tends to 1, by a polynomial in 1/(x + 2).

inline constexpr double gamma_split = 2;

namespace gamma_fits {

/// sum_k (-x)^k/(k! (2k + c)) = int_0^1 r^(c-1) e^(-x r^2) dr for x = (1 + z) gamma_split/2.
template <int c>
inline constexpr auto series = chebyshev_fit<16>([](long double z) {
  const long double x = (1 + z) * gamma_split / 2;
  long double power = 1, sum = 1.0L / c;
  for (int k = 1; k < 40; ++k) sum += (power *= -x / k) / (2 * k + c);
  return sum;
});

/// (E1(x) + ln x + gamma)/x = sum_k (-x)^k/((k + 1)! (k + 1)), likewise.
inline constexpr auto rise_of_e1 = chebyshev_fit<16>([](long double z) {
  const long double x = (1 + z) * gamma_split / 2;
  long double power = 1, sum = 1;
  for (int k = 2; k < 40; ++k) sum += (power *= -x / k) / k;
  return sum;
});

/// Gamma(a, x) is nothing beside Gamma(a) from here on.
inline constexpr double no_tail = 40;

/// 1/(x + 2) = middle + half_width z.
inline constexpr double shift = 2;
inline constexpr double middle = 0.5 / (gamma_split + shift) + 0.5 / (no_tail + shift);
inline constexpr double half_width = 0.5 / (gamma_split + shift) - 0.5 / (no_tail + shift);

/// Gamma(a, x) e^x x^-a (x + 2), a = twice_a/2, by the continued fraction
///   Gamma(a, x) e^x x^-a = 1/(x+1-a - 1(1-a)/(x+3-a - 2(2-a)/(x+5-a - ...))).
template <int twice_a>
inline constexpr auto tail = chebyshev_fit<20>([](long double z) {
  constexpr long double a = twice_a / 2.0L;
  const long double x = 1 / (middle + half_width * z) - shift;
  long double fraction = 0;
  for (int k = 200; k >= 1; --k) fraction = k * (k - a) / (x + 2 * k + 1 - a - fraction);
  return (x + shift) / (x + 1 - a - fraction);
});

/// Gamma(a, x) e^x x^-a for gamma_split <= x <= no_tail, and beyond it the value there.
template <int twice_a>
[[gnu::always_inline]] inline Lanes scaled_tail(const Lanes& x) {
  const Lanes inverse = 1 / (at_most(no_tail, x) + shift);
  return inverse * polynomial(tail<twice_a>, (inverse - middle) * (1 / half_width));
}

template <int c>
[[gnu::always_inline]] inline Lanes near_series(const Lanes& x) {
  return polynomial(series<c>, x * (2 / gamma_split) - 1);
}

/// sum_k (-x)^k/(k! (2k + c)) for x >= gamma_split, from c = 1 or 2 upwards.
template <int c>
[[gnu::always_inline]] inline Lanes far_series(const Lanes& x) {
  const Lanes decay = exponential(-at_most(700, x));
  if constexpr (c == 1) {
    constexpr double half_root_of_pi = 0.5 / std::numbers::inv_sqrtpi;
    return half_root_of_pi / sqrt(x) - 0.5 * decay * scaled_tail<1>(x);
  } else if constexpr (c == 2) {
    return (1 - decay) / (2 * x);
  } else {
    return ((c - 2) * far_series<c - 2>(x) - decay) / (2 * x);
  }
}

}  // namespace gamma_fits

/// int_0^1 r^(c-1) e^(-x r^2) dr = gamma(c/2, x)/(2 x^(c/2)) for x >= 0, c = 1 to 5.
template <int c>
[[gnu::always_inline]] inline Lanes gamma_series(const Lanes& x) {
  if constexpr (c == 2) {
    const Lanes positive = x + 1e-300;  // the same number, but for 0
    return exponential_rise(at_most(700, positive)) / (2 * positive);
  } else {
    Lanes sum = gamma_fits::far_series<c>(at_least(gamma_split, x));
    where(x < gamma_split, sum) = gamma_fits::near_series<c>(x);
    return sum;
  }
}

/// ln 2x + E1(x), finite at x = 0.
[[gnu::always_inline]] inline Lanes smooth_logarithm(const Lanes& x) {
  const Lanes far = at_least(gamma_split, x), decay = exponential(-at_most(700, far));
  Lanes sum = logarithm(2 * far) + decay * gamma_fits::scaled_tail<0>(far);
  constexpr double at_0 = std::numbers::ln2_v<long double> - std::numbers::egamma_v<long double>;
  where(x < gamma_split, sum) =
      at_0 + x * polynomial(gamma_fits::rise_of_e1, x * (2 / gamma_split) - 1);
  return sum;
}

}  // namespace mote
