#pragma once

#include <cstddef>

namespace mote {

/// Where the coefficients of real solid harmonics stand. An expansion of a degree p is a sum over
/// degrees n <= p and orders m <= n of cosine coefficients (m = 0..n) and sine coefficients
/// (m = 1..n). Degrees come one after the other, so an expansion of a lower degree is the beginning
/// of one of a higher degree; within a degree all cosines come first.
///
/// The harmonics are r^n S_n^m with Schmidt's normalisation,
///   S_n^0 = P_n(cos theta),  S_n^m = sqrt(2 (n-m)!/(n+m)!) P_n^m(cos theta) {cos, sin}(m phi)
/// without the sign (-1)^m, so that P_n(cos of the angle between u and v) = sum S_n^m(u) S_n^m(v).

/// The highest degree of an expansion.
inline constexpr int highest_degree = 40;

/// Coefficients of all degrees up to `degree`; also the place where degree + 1 begins.
constexpr std::size_t harmonic_count(int degree) {
  return static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(degree + 1);
}
constexpr std::size_t cosine_place(int degree, int order) {
  return harmonic_count(degree - 1) + static_cast<std::size_t>(order);
}
constexpr std::size_t sine_place(int degree, int order) {
  return harmonic_count(degree - 1) + static_cast<std::size_t>(degree + order);
}

/// The same coefficients order by order: first the degrees of the cosines of order 0, then of the
/// cosines of order 1, of the sines of order 1, and so on. Orders are matrices of their own where
/// the axis is the displacement.
constexpr std::size_t by_order(int degree, int order) {
  const auto degrees = static_cast<std::size_t>(degree + 1), m = static_cast<std::size_t>(order);
  return order == 0 ? 0 : m * (2 * degrees - m + 1) - degrees;
}
/// Degrees of an order.
constexpr std::size_t degrees_of(int degree, int order) {
  return static_cast<std::size_t>(degree - order + 1);
}

}  // namespace mote
