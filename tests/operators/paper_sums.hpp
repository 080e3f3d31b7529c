#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "support/brute_force.hpp"

namespace mote::test {

/// What the paper's sums give at every receiver, in long double.
struct WideDerivatives {
  std::vector<long double> gradient, divergence, laplacian, curl, hessian;
};

template <std::size_t D>
using WideVector = std::array<long double, D>;

template <std::size_t D>
long double dot(const WideVector<D>& a, const WideVector<D>& b) {
  long double sum = 0;
  for (std::size_t d = 0; d < D; ++d) sum += a[d] * b[d];
  return sum;
}

/// Adds factor a x b, which has no component on a line, one in 2D and three in 3D.
template <std::size_t D>
void add_cross(long double factor, const WideVector<D>& a, const WideVector<D>& b,
               std::array<long double, 3>& sum) {
  const auto minor = [&](std::size_t c, std::size_t d) {
    return factor * (a[c] * b[d] - a[d] * b[c]);
  };
  if constexpr (D == 2) sum[0] += minor(0, 1);
  if constexpr (D == 3) {
    sum[0] += minor(1, 2);
    sum[1] += minor(2, 0);
    sum[2] += minor(0, 1);
  }
}

template <std::size_t D>
void append_curl(const std::array<long double, 3>& sum, WideDerivatives& result) {
  for (std::size_t d = 0; d < (D == 1 ? 0 : (D == 2 ? 1 : 3)); ++d) result.curl.push_back(sum[d]);
}

/// One receiver and what its sums need of every point: the sums run over all points, of which a
/// weight takes those within its reach.
template <int D>
struct Row {
  Index i;
  std::vector<WideVector<D>> x;               ///< x_i - x_j
  std::vector<long double> r, h, difference;  ///< distance, length, phi_i - phi_j
  std::vector<WideVector<D>> a;               ///< a_i - a_j

  Row(const Points<D>& points, const NeighbourRule& rule, Index receiver,
      const std::vector<double>& phi, const std::vector<double>& field)
      : i(receiver) {
    for (Index j = 0; j < points.size(); ++j) {
      WideVector<D> x_ij, a_ij;
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

/// What the kernel smooths: M and rho in section 2, Omega and omega in section 3.
struct Smoothed {
  std::vector<long double> amount, density;
};

inline std::vector<long double> widened(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// The sum (9), (10) or (44) over the kernel at every receiver, the receiver itself included.
template <int D, class Kernel>
std::vector<long double> summed_density(const Points<D>& points, const NeighbourRule& rule,
                                        const Kernel& kernel, const std::vector<double>& amount) {
  std::vector<long double> density;
  for (Index i = 0; i < points.receivers; ++i) {
    density.push_back(0);
    for (Index j = 0; j < points.size(); ++j) {
      const long double h = wide_smoothing_length(points, rule, i, j);
      const auto q = static_cast<double>(wide_distance(points, i, j) / h);
      density[i] += amount[j] * kernel.value(q) / std::pow(h, D);
    }
  }
  return density;
}

/// (27) to (30) of Isshiki (2014), the second derivatives as the double sums that are printed. The
/// weights w'(r_ij) and w''(r_ij) are those of all points; they are 0 out of reach.
template <int D>
class PrintedSums {
 public:
  PrintedSums(const Row<D>& row, const Smoothed& smoothed, std::vector<long double> slope,
              std::vector<long double> curvature)
      : row_(row),
        m_(smoothed.amount),
        rho_(smoothed.density[row.i]),
        w1_(std::move(slope)),
        w2_(std::move(curvature)) {
    for (std::size_t j = 0; j < w1_.size(); ++j)
      if (static_cast<Index>(j) != row.i && (w1_[j] != 0 || w2_[j] != 0)) reached_.push_back(j);
  }

  void add_to(WideDerivatives& result) const {
    add_first(result);
    result.laplacian.push_back(laplacian());
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) result.hessian.push_back(hessian(c, d));
  }

 private:
  void add_first(WideDerivatives& result) const {
    WideVector<D> gradient{};
    std::array<long double, 3> curl{};
    long double divergence = 0;
    for (const std::size_t j : reached_) {
      const long double factor = -w1_[j] / row_.r[j] * m_[j] / rho_;
      for (int d = 0; d < D; ++d) gradient[d] += factor * row_.x[j][d] * row_.difference[j];
      divergence += factor * dot(row_.x[j], row_.a[j]);
      add_cross(factor, row_.x[j], row_.a[j], curl);
    }
    result.gradient.insert(result.gradient.end(), gradient.begin(), gradient.end());
    result.divergence.push_back(divergence);
    append_curl<D>(curl, result);
  }

  long double laplacian() const {
    long double single_sum = 0, double_sum = 0;
    for (const std::size_t j : reached_) {
      const long double r = row_.r[j], difference = row_.difference[j];
      single_sum += (w2_[j] + w1_[j] * (D - 1) / r) * difference * m_[j];
      for (const std::size_t k : reached_)
        double_sum += w1_[k] * w1_[j] * dot(row_.x[j], row_.x[k]) / (r * row_.r[k]) * difference *
                      m_[j] * m_[k];
    }
    return (-single_sum + 2 / rho_ * double_sum) / rho_;
  }

  long double hessian(int c, int d) const {
    long double single_sum = 0, double_sum = 0;
    for (const std::size_t j : reached_) {
      const auto& x = row_.x[j];
      const long double r = row_.r[j], difference = row_.difference[j];
      single_sum +=
          (w2_[j] * x[c] * x[d] / (r * r) + w1_[j] * ((c == d) / r - x[c] * x[d] / (r * r * r))) *
          difference * m_[j];
      for (const std::size_t k : reached_)
        double_sum += w1_[k] * w1_[j] * (x[d] * row_.x[k][c] + x[c] * row_.x[k][d]) /
                      (r * row_.r[k]) * difference * m_[j] * m_[k];
    }
    return (-single_sum + double_sum / rho_) / rho_;
  }

  const Row<D>& row_;
  const std::vector<long double>& m_;
  long double rho_;
  std::vector<long double> w1_, w2_;
  std::vector<std::size_t> reached_;
};

template <int D, class Kernel>
void add_sph_row(const Kernel& kernel, const Row<D>& row, const Smoothed& smoothed,
                 WideDerivatives& result) {
  std::vector<long double> w1, w2;
  for (std::size_t j = 0; j < row.r.size(); ++j) {
    const long double q = row.r[j] / row.h[j];
    w1.push_back(q * kernel.slope_over_q(static_cast<double>(q)) / std::pow(row.h[j], D + 1));
    w2.push_back(kernel.curvature(static_cast<double>(q)) / std::pow(row.h[j], D + 2));
  }
  PrintedSums<D>(row, smoothed, w1, w2).add_to(result);
}

/// (70) and (71) of Isshiki (2014) with the weight of Table 3; in D dimensions with the factor D of
/// Koshizuka & Oka (1996), divergence and curl as parts of the gradient, and the Hessian of Espanol
/// & Revenga (2003).
template <int D>
void add_mps_row(const Row<D>& row, WideDerivatives& result) {
  long double n = 0, moment = 0, divergence = 0, laplacian = 0;
  WideVector<D> gradient{};
  std::array<long double, 3> curl{};
  std::array<WideVector<D>, D> hessian{};
  for (std::size_t j = 0; j < row.r.size(); ++j) {
    if (static_cast<Index>(j) == row.i || row.r[j] >= row.h[j]) continue;
    const auto& x = row.x[j];
    const long double r2 = row.r[j] * row.r[j], w = row.h[j] / row.r[j] - 1;
    n += w;
    moment += r2 * w;
    divergence += dot(row.a[j], x) / r2 * w;
    add_cross(w / r2, x, row.a[j], curl);
    laplacian -= row.difference[j] * w;
    for (int c = 0; c < D; ++c) {
      gradient[c] += row.difference[j] / r2 * x[c] * w;
      for (int d = 0; d < D; ++d)
        hessian[c][d] -= row.difference[j] * w * ((D + 2) * x[c] * x[d] / r2 - (c == d));
    }
  }
  const long double lambda = moment / n;
  for (long double& component : curl) component *= D / n;
  append_curl<D>(curl, result);
  for (int d = 0; d < D; ++d) result.gradient.push_back(D / n * gradient[d]);
  result.divergence.push_back(D / n * divergence);
  result.laplacian.push_back(2 * D / (lambda * n) * laplacian);
  for (const auto& line : hessian)
    for (const long double entry : line) result.hessian.push_back(D / (lambda * n) * entry);
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
