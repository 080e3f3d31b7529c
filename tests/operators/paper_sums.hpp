#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "support/brute_force.hpp"

namespace mote::test {

/// What the paper's sums give at every receiver, in long double.
struct WideDerivatives {
  std::vector<long double> gradient, divergence, laplacian;
};

/// One receiver and what its sums need of every point: the sums run over all points, of which a
/// weight takes those within its reach.
template <int D>
struct Row {
  Index i;
  std::vector<std::array<long double, D>> x;  ///< x_i - x_j
  std::vector<long double> r, h, difference;  ///< distance, length, phi_i - phi_j
  std::vector<std::array<long double, D>> a;  ///< a_i - a_j

  Row(const Points<D>& points, const NeighbourRule& rule, Index receiver,
      const std::vector<double>& phi, const std::vector<double>& field)
      : i(receiver) {
    for (Index j = 0; j < points.size(); ++j) {
      std::array<long double, D> x_ij, a_ij;
      for (int d = 0; d < D; ++d) {
        x_ij[d] = static_cast<long double>(points.position[i * D + d]) - points.position[j * D + d];
        a_ij[d] = static_cast<long double>(field[i * D + d]) - field[j * D + d];
      }
      x.push_back(x_ij);
      a.push_back(a_ij);
      r.push_back(wide_distance(points, i, j));
      h.push_back(wide_smoothing_length(points, rule, i, j));
      difference.push_back(static_cast<long double>(phi[i]) - phi[j]);
    }
  }
};

template <std::size_t D>
long double dot(const std::array<long double, D>& a, const std::array<long double, D>& b) {
  long double sum = 0;
  for (std::size_t d = 0; d < D; ++d) sum += a[d] * b[d];
  return sum;
}

/// (28), (29) and (30) of Isshiki (2014), the last as the double sum that is printed.
template <int D, class Kernel>
void add_sph_row(const Points<D>& points, const Kernel& kernel, const Row<D>& row,
                 WideDerivatives& result) {
  const Index i = row.i, n = points.size();
  const long double rho = points.density[i];
  std::vector<long double> w1(n), w2(n);  // w'(r_ij), w''(r_ij)
  for (Index j = 0; j < n; ++j) {
    const long double q = row.r[j] / row.h[j];
    w1[j] = q * kernel.slope_over_q(static_cast<double>(q)) / std::pow(row.h[j], D + 1);
    w2[j] = kernel.curvature(static_cast<double>(q)) / std::pow(row.h[j], D + 2);
  }
  std::array<long double, D> gradient{};
  long double divergence = 0, single_sum = 0, double_sum = 0;
  for (Index j = 0; j < n; ++j) {
    if (j == i || w1[j] == 0) continue;
    const long double mass = points.mass[j], r = row.r[j];
    for (int d = 0; d < D; ++d)
      gradient[d] -= w1[j] * row.x[j][d] / r * row.difference[j] * mass / rho;
    divergence -= w1[j] * dot(row.x[j], row.a[j]) / r * mass / rho;
    single_sum += (w2[j] + w1[j] * (D - 1) / r) * row.difference[j] * mass;
    for (Index k = 0; k < n; ++k)
      if (k != i)
        double_sum += w1[k] * w1[j] * dot(row.x[j], row.x[k]) / (r * row.r[k]) * row.difference[j] *
                      mass * points.mass[k];
  }
  for (int d = 0; d < D; ++d) result.gradient.push_back(gradient[d]);
  result.divergence.push_back(divergence);
  result.laplacian.push_back((-single_sum + 2 / rho * double_sum) / rho);
}

/// (70) and (71) of Isshiki (2014) with the weight of Table 3; in D dimensions with the factor D of
/// Koshizuka & Oka (1996), and the divergence as the trace of the gradient.
template <int D>
void add_mps_row(const Points<D>& points, const Row<D>& row, WideDerivatives& result) {
  long double n = 0, moment = 0, divergence = 0, laplacian = 0;
  std::array<long double, D> gradient{};
  for (Index j = 0; j < points.size(); ++j) {
    if (j == row.i || row.r[j] >= row.h[j]) continue;
    const long double r2 = row.r[j] * row.r[j], w = row.h[j] / row.r[j] - 1;
    n += w;
    moment += r2 * w;
    for (int d = 0; d < D; ++d) gradient[d] += row.difference[j] / r2 * row.x[j][d] * w;
    divergence += dot(row.a[j], row.x[j]) / r2 * w;
    laplacian -= row.difference[j] * w;
  }
  const long double lambda = moment / n;
  for (int d = 0; d < D; ++d) result.gradient.push_back(D / n * gradient[d]);
  result.divergence.push_back(D / n * divergence);
  result.laplacian.push_back(2 * D / (lambda * n) * laplacian);
}

/// Calls add(row, result) for every receiver.
template <int D, class Add>
WideDerivatives paper_sums(const Points<D>& points, const NeighbourRule& rule,
                           const std::vector<double>& phi, const std::vector<double>& field,
                           Add add) {
  WideDerivatives result;
  for (Index i = 0; i < points.receivers; ++i) add(Row<D>(points, rule, i, phi, field), result);
  return result;
}

}  // namespace mote::test
