#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "study/printed_mesh.hpp"

namespace mote::test {

using Wide = long double;

/// w'(r) and w''(r) of a weight of Table 3 of Isshiki (2014) with the length h, derived by hand
/// from w, (59) corrected: gamma stands outside the root.
struct Slopes {
  Wide first = 0, second = 0;
};
using PrintedWeight = std::function<Slopes(Wide r, Wide h)>;

inline Slopes gauss(Wide r, Wide h) {
  const Wide w = std::exp(-r * r / (2 * h * h)) / (std::sqrt(2 * std::numbers::pi_v<Wide>) * h);
  return {-r / (h * h) * w, (r * r / (h * h) - 1) / (h * h) * w};
}

/// 5/(4 h) (1 + 3 q)(1 - q)^3, q = r/h.
inline Slopes lucy(Wide r, Wide h) {
  const Wide q = r / h, norm = Wide{5} / 4;
  if (q > 1) return {};
  return {-12 * norm * q * (1 - q) * (1 - q) / (h * h),
          -12 * norm * (1 - q) * (1 - 3 * q) / (h * h * h)};
}

/// 4/(3 h) (1 - 6 q^2 + 6 q^3) below h/2, and 4/(3 h) 2 (1 - q)^3 up to h.
inline Slopes cubic(Wide r, Wide h) {
  const Wide q = r / h, norm = Wide{4} / 3;
  if (q > 1) return {};
  if (q < 0.5L) return {norm * (18 * q * q - 12 * q) / (h * h), norm * (36 * q - 12) / (h * h * h)};
  return {-6 * norm * (1 - q) * (1 - q) / (h * h), 12 * norm * (1 - q) / (h * h * h)};
}

/// The cells of a line, as the sums see them.
struct PrintedLine {
  PrintedCells cells;
  int begin = 0, end = 0;  ///< the cells of the line itself
  std::vector<Wide> field, density;
};

/// The length that a pair's weight uses: `scale` times that of i and j in the mean, of j or of i.
struct PrintedLength {
  Wide scale = 1;
  std::string of = "mean";
  Wide operator()(Wide dx_i, Wide dx_j) const {
    if (of == "scatter") return scale * dx_j;
    return scale * (of == "gather" ? dx_i : (dx_i + dx_j) / 2);
  }
};

struct PrintedDerivatives {
  std::vector<Wide> gradient, laplacian;
};

/// (61) and (62), the double sum as printed, over all other cells.
inline PrintedDerivatives printed_sph(const PrintedLine& line, const PrintedWeight& weight,
                                      const PrintedLength& length) {
  const auto& [x, dx] = line.cells;
  PrintedDerivatives result;
  for (int i = line.begin; i < line.end; ++i) {
    std::vector<Wide> e_w1, w2, difference, mass;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (static_cast<int>(j) == i) continue;
      const Wide r = std::abs(x[i] - x[j]);
      const Slopes w = weight(r, length(dx[i], dx[j]));
      e_w1.push_back(w.first * (x[i] - x[j]) / r);
      w2.push_back(w.second);
      difference.push_back(line.field[i] - line.field[j]);
      mass.push_back(line.density[j] * dx[j]);
    }
    Wide gradient = 0, single_sum = 0, double_sum = 0;
    for (std::size_t j = 0; j < mass.size(); ++j) {
      gradient -= e_w1[j] * difference[j] * mass[j];
      single_sum -= w2[j] * difference[j] * mass[j];
      for (std::size_t k = 0; k < mass.size(); ++k)
        double_sum += e_w1[k] * e_w1[j] * difference[j] * mass[j] * mass[k];
    }
    const Wide rho = line.density[i];
    result.gradient.push_back(gradient / rho);
    result.laplacian.push_back((single_sum + 2 / rho * double_sum) / rho);
  }
  return result;
}

/// (70) and (71) with w = h/r - 1.
inline PrintedDerivatives printed_mps(const PrintedLine& line, const PrintedLength& length) {
  const auto& [x, dx] = line.cells;
  PrintedDerivatives result;
  for (int i = line.begin; i < line.end; ++i) {
    Wide n = 0, moment = 0, gradient = 0, laplacian = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const Wide r = std::abs(x[j] - x[i]), h = length(dx[i], dx[j]);
      if (static_cast<int>(j) == i || r >= h) continue;
      const Wide w = h / r - 1, difference = line.field[j] - line.field[i];
      n += w;
      moment += r * r * w;
      gradient += difference / (r * r) * (x[j] - x[i]) * w;
      laplacian += difference * w;
    }
    const Wide lambda = moment / n;
    result.gradient.push_back(gradient / n);
    result.laplacian.push_back(2 / (lambda * n) * laplacian);
  }
  return result;
}

}  // namespace mote::test
