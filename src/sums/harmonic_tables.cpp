#include "mote/sums/harmonic_tables.hpp"

#include <cmath>
#include <numbers>

namespace mote {
namespace {

using Real = long double;
using Matrix = std::vector<std::vector<Real>>;  ///< a degree's, by orders; cosines or sines

constexpr Real root_of_2 = std::numbers::sqrt2_v<Real>;

/// d/dx of the harmonic (n, m) is slope_below(n, m) times (n-1, m-1) plus slope_above(n, m) times
/// (n-1, m+1).
Real slope_below(int n, int m) {
  if (m == 0) return 0;
  return std::sqrt(static_cast<Real>(n + m) * (n + m - 1)) / 2 * (m == 1 ? root_of_2 : 1);
}
Real slope_above(int n, int m) {
  return -std::sqrt(static_cast<Real>(n - m) * (n - m - 1)) / 2 * (m == 0 ? root_of_2 : 1);
}

/// The matrix X of degree n from that of n - 1. A harmonic with x and z exchanged is H = sum_k
/// X_mk R_n^k. Its derivative along z, in which only one term has each order k < n left, is that of
/// R_n^m along x, exchanged. The last column follows from symmetry, and its corner from dH/dx,
/// which for m = n is 0.
Matrix next_exchange(int n, const Matrix& last, bool sines) {
  const auto size = static_cast<std::size_t>(n + 1);
  Matrix x(size, std::vector<Real>(size));
  const auto of_last = [&](int m, int k) {
    return m < 0 || m >= n ? 0 : last[static_cast<std::size_t>(m)][static_cast<std::size_t>(k)];
  };
  const auto at = [&](int m, int k) -> Real& {
    return x[static_cast<std::size_t>(m)][static_cast<std::size_t>(k)];
  };
  const int first = sines ? 1 : 0;
  for (int k = first; k < n; ++k)
    for (int m = first; m <= n; ++m)
      at(m, k) = (slope_below(n, m) * of_last(m - 1, k) + slope_above(n, m) * of_last(m + 1, k)) /
                 std::sqrt(static_cast<Real>(n - k) * (n + k));
  for (int m = first; m < n; ++m) at(m, n) = at(n, m);
  if (n == 1) at(1, 1) = sines ? 1 : 0;
  if (n >= 2) at(n, n) = -at(n, n - 2) * slope_above(n, n - 2) / slope_below(n, n);
  return x;
}

/// The number of an order within a block's coefficient place.
std::size_t order_at(int degree, int place, bool sines) {
  return static_cast<std::size_t>(sines ? place - degree : place);
}

Real binomial(int n, int k) {
  Real product = 1;
  for (int i = 1; i <= k; ++i) product = product * (n - k + i) / i;
  return product;
}

}  // namespace

HarmonicTables::HarmonicTables() {
  fill_exchange();
  fill_translations();
  fill_recurrences();
  fill_slopes();
}

void HarmonicTables::fill_exchange() {
  Matrix cosines{{1}}, sines{{0}};
  for (int n = 0; n <= highest_degree; ++n) {
    if (n > 0) {
      cosines = next_exchange(n, cosines, false);
      sines = next_exchange(n, sines, true);
    }
    exchange_place_[n] = exchange_.size();
    for (int number = 0; number < 4; ++number) {
      const ExchangeBlock block = exchange_block(n, number);
      const Matrix& matrix = number < 2 ? cosines : sines;
      for (int k = 0; k < block.inputs; ++k)
        for (int m = 0; m < block.outputs; ++m)
          exchange_.push_back(
              static_cast<double>(matrix[order_at(n, block.first_output + 2 * m, number >= 2)]
                                        [order_at(n, block.first_input + 2 * k, number >= 2)]));
    }
  }
}

void HarmonicTables::fill_translations() {
  for (int m = 0; m <= highest_degree; ++m) {
    order_place_[m] = inward_.size();
    for (int n = m; n <= highest_degree; ++n)
      for (int l = m; l <= highest_degree; ++l) {
        const Real inward = std::sqrt(binomial(n + l, n - m) * binomial(n + l, n + m));
        inward_.push_back(static_cast<double>((l + m) % 2 == 0 ? inward : -inward));
        centre_.push_back(l < n ? 0
                                : static_cast<double>(
                                      std::sqrt(binomial(l - m, l - n) * binomial(l + m, l - n))));
      }
  }
}

void HarmonicTables::fill_recurrences() {
  rise_.resize(rise_place(highest_degree + 1));
  fall_.resize(rise_.size());
  for (int m = 0; m <= highest_degree; ++m) {
    first_.push_back(m < 2 ? 1 : std::sqrt((2.0 * m - 1) / (2.0 * m)));
    for (int n = m + 1; n <= highest_degree; ++n) {
      const double root = std::sqrt(static_cast<double>((n - m) * (n + m)));
      const std::size_t place = rise_place(m) + static_cast<std::size_t>(n - m);
      rise_[place] = (2 * n - 1) / root;
      fall_[place] = std::sqrt(static_cast<double>((n - m - 1) * (n + m - 1))) / root;
    }
  }
}

void HarmonicTables::fill_slopes() {
  for (int n = 0; n <= highest_degree; ++n)
    for (int m = 0; m <= n; ++m) {
      below_.push_back(static_cast<double>(slope_below(n, m)));
      above_.push_back(static_cast<double>(slope_above(n, m)));
      along_.push_back(std::sqrt(static_cast<double>((n - m) * (n + m))));
    }
}

const HarmonicTables& harmonic_tables() {
  static const HarmonicTables tables;
  return tables;
}

}  // namespace mote
