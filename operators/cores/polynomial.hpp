#pragma once

#include <array>
#include <cstddef>
#include <numbers>

namespace mote {

/// sum_k coefficients[k] x^k, even and odd powers apart: two short chains of operations instead of
/// a long one.
template <class Real, std::size_t N>
[[gnu::always_inline]] constexpr Real polynomial(const std::array<double, N>& coefficients,
                                                 const Real& x) {
  const Real square = x * x;
  Real even = coefficients[(N - 1) / 2 * 2], odd = N > 1 ? coefficients[N / 2 * 2 - 1] : 0;
  for (std::size_t k = (N - 1) / 2 * 2; k > 0; k -= 2) even = even * square + coefficients[k - 2];
  for (std::size_t k = N / 2 * 2 - 1; k > 1; k -= 2) odd = odd * square + coefficients[k - 2];
  return even + x * odd;
}

/// The cosine by its series, for 0 <= x <= pi.
constexpr long double cosine(long double x) {
  long double term = 1, sum = 1;
  for (int k = 2; k < 60; k += 2) sum += term *= -x * x / (k * (k - 1));
  return sum;
}

/// The coefficients in powers of z of the polynomial that equals f at the N Chebyshev points of
/// -1 <= z <= 1. Meant for compilation time.
template <std::size_t N, class Function>
constexpr std::array<double, N> chebyshev_fit(Function f) {
  using Row = std::array<long double, N>;
  Row value{};
  const auto angle = [](std::size_t k) {
    return std::numbers::pi_v<long double> * (2 * k + 1) / (2 * N);
  };
  for (std::size_t k = 0; k < N; ++k) value[k] = f(cosine(angle(k)));
  Row before{}, now{}, sum{};  // powers in the Chebyshev polynomials n - 1 and n
  now[0] = 1;
  for (std::size_t n = 0; n < N; ++n) {
    Row next{};
    long double amplitude = 0;
    for (std::size_t k = 0; k < N; ++k) {
      const std::size_t turn = n * (2 * k + 1) % (4 * N);  // of 4 N quarters of an angle step
      amplitude +=
          value[k] * (turn <= 2 * N ? cosine(turn * angle(0)) : cosine((4 * N - turn) * angle(0)));
    }
    amplitude *= (n == 0 ? 1.0L : 2.0L) / N;
    for (std::size_t k = 0; k < N; ++k) {
      sum[k] += amplitude * now[k];
      next[k] = (k > 0 ? (n == 0 ? 1 : 2) * now[k - 1] : 0) - before[k];
    }
    before = now;
    now = next;
  }
  std::array<double, N> coefficients{};
  for (std::size_t k = 0; k < N; ++k) coefficients[k] = static_cast<double>(sum[k]);
  return coefficients;
}

/// The coefficients for powers of x = scale z of a polynomial given for those of z.
template <std::size_t N>
constexpr std::array<double, N> in_powers_of(double scale, std::array<double, N> coefficients) {
  long double power = 1;
  for (double& coefficient : coefficients) {
    coefficient = static_cast<double>(coefficient / power);
    power *= scale;
  }
  return coefficients;
}

}  // namespace mote
