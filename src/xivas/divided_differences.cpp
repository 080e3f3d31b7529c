#include "mote/xivas/divided_differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace mote {
namespace {

constexpr std::size_t most_nodes = 5;

void check_count(std::size_t count) {
  if (count < 1 || count > most_nodes)
    throw std::invalid_argument("a divided difference has between one and five nodes here");
}

/// exp[x1; ...; xk] = e^x1 sum_j h_j(x2 - x1, ..., xk - x1) / (j + k - 1)!, h_j the sum of all
/// products of j of its arguments, repeated or not. Nodes ascend.
template <typename Real>
Real series_about_smallest(std::span<const Real> nodes) {
  const std::size_t count = nodes.size();
  std::array<Real, most_nodes> term{};  // of the first two, three, ... nodes
  Real factorial = 1;
  for (std::size_t n = 2; n < count; ++n) factorial *= static_cast<Real>(n);
  term.fill(1 / factorial);
  Real sum = term[count - 1];
  const Real spread = nodes.back() - nodes.front();
  for (Real n = static_cast<Real>(count);; ++n) {
    Real fewer = 0;
    for (std::size_t i = 1; i < count; ++i)
      fewer = term[i] = fewer + (nodes[i] - nodes.front()) * term[i] / n;
    const Real next = count == 1 ? 0 : fewer;
    sum += next;
    if (n > 2 * spread && next <= std::numeric_limits<Real>::epsilon() / 8 * sum) break;
  }
  return std::exp(nodes.front()) * sum;
}

/// Further apart than this, the two differences of the recurrence differ by a factor of three.
constexpr double far_apart = 12;

template <typename Real>
Real sorted_difference(std::span<const Real> nodes) {
  const Real spread = nodes.back() - nodes.front();
  if (spread <= far_apart) return series_about_smallest(nodes);
  const std::size_t fewer = nodes.size() - 1;
  return (sorted_difference(nodes.last(fewer)) - sorted_difference(nodes.first(fewer))) / spread;
}

/// Entry (i, j), j >= i: exp[z_i; ...; z_j].
template <typename Real>
using Table = std::array<std::array<std::complex<Real>, most_nodes>, most_nodes>;

/// The sum of Z^n / n!, Z with the nodes, all of size 1/2 at most, on its diagonal and ones above.
template <typename Real>
Table<Real> series_table(std::span<const std::complex<Real>> nodes) {
  Table<Real> term{}, sum{};
  for (std::size_t i = 0; i < nodes.size(); ++i) sum[i][i] = term[i][i] = 1;
  const auto last = static_cast<int>(nodes.size()) - 1;
  Real smallness = 1;  // of a term: m factors of 1/2, over m!
  for (int n = 1; smallness > std::numeric_limits<Real>::epsilon() / 64; ++n) {
    if (n > last) smallness /= static_cast<Real>(2 * (n - last));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = nodes.size(); j-- > i;) {
        const auto left = j > i ? term[i][j - 1] : std::complex<Real>{};
        term[i][j] = (term[i][j] * nodes[j] + left) / static_cast<Real>(n);
        sum[i][j] += term[i][j];
      }
  }
  return sum;
}

/// From nodes z / 2 to nodes z: entry (i, j) of the square is 2^(j - i) exp[z_i; ...; z_j]. The
/// diagonal is known and not squared, so that rounding adds up instead of doubling.
template <typename Real>
void square(Table<Real>& table, std::span<const std::complex<Real>> nodes, Real scale) {
  const Table<Real> half = table;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    table[i][i] = std::exp(nodes[i] * scale);
    for (std::size_t j = i + 1; j < nodes.size(); ++j) {
      std::complex<Real> sum{};
      for (std::size_t l = i; l <= j; ++l) sum += half[i][l] * half[l][j];
      table[i][j] = std::ldexp(Real(1), static_cast<int>(i) - static_cast<int>(j)) * sum;
    }
  }
}

}  // namespace

template <typename Real>
Real exponential_difference(std::span<const Real> nodes) {
  check_count(nodes.size());
  std::array<Real, most_nodes> ascending;
  auto end = ascending.begin();
  for (const Real node : nodes) {
    const auto place = std::upper_bound(ascending.begin(), end, node);
    std::copy_backward(place, end, end + 1);
    *place = node;
    ++end;
  }
  return sorted_difference(std::span<const Real>(ascending.begin(), nodes.size()));
}

template <typename Real>
std::complex<Real> exponential_difference(std::span<const std::complex<Real>> nodes) {
  check_count(nodes.size());
  Real largest = 0;
  for (const auto& node : nodes) largest = std::max(largest, std::abs(node));
  const int squarings = largest > Real(0.5) ? std::ilogb(largest) + 2 : 0;
  std::array<std::complex<Real>, most_nodes> scaled;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    scaled[i] = nodes[i] * std::ldexp(Real(1), -squarings);
  auto table = series_table(std::span<const std::complex<Real>>(scaled.data(), nodes.size()));
  for (int s = squarings; s-- > 0;) square(table, nodes, std::ldexp(Real(1), -s));
  return table[0][nodes.size() - 1];
}

template double exponential_difference(std::span<const double>);
template long double exponential_difference(std::span<const long double>);
template std::complex<double> exponential_difference(std::span<const std::complex<double>>);
template std::complex<long double> exponential_difference(
    std::span<const std::complex<long double>>);

}  // namespace mote
