#pragma once

#include <array>

#include "mote/particles/vector.hpp"

namespace mote {

/// Number of second derivatives that differ: 1, 3, 6.
template <int D>
inline constexpr int second_derivatives = D*(D + 1) / 2;

/// The products x_c x_d, c <= d, in the order xx, xy, xz, yy, yz, zz.
template <int D>
Eigen::Matrix<double, second_derivatives<D>, 1> products_of(const Vec<D>& x) {
  Eigen::Matrix<double, second_derivatives<D>, 1> products;
  int s = 0;
  for (int c = 0; c < D; ++c)
    for (int d = c; d < D; ++d) products[s++] = x[c] * x[d];
  return products;
}

/// Number of monomials of degree 1 to `degree` in `dimension` coordinates.
constexpr int monomial_count(int dimension, int degree) {
  int count = 1;
  for (int k = 1; k <= dimension; ++k) count = count * (degree + k) / k;
  return count - 1;
}

/// The monomials of degree 1 to Degree in D coordinates, by rising degree: x, y, z, then xx, xy,
/// xz, yy, yz, zz, and so on. Those of a lower degree are the first of them. From the D-th on, each
/// is an earlier one, its parent, times one coordinate.
template <int D, int Degree>
struct Monomials {
  static constexpr int count = monomial_count(D, Degree);
  std::array<int, count> parent{}, axis{};

  constexpr Monomials() {
    int next = 0;
    for (int d = 0; d < D; ++d, ++next) axis[next] = d;
    for (int first = 0; next < count;) {
      const int end = next;
      for (int k = first; k < end; ++k)
        for (int d = axis[k]; d < D; ++d, ++next) {
          parent[next] = k;
          axis[next] = d;
        }
      first = end;
    }
  }
};

}  // namespace mote
