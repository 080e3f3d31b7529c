#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "mote/operators/differential/lanes.hpp"

namespace mote {

/// The triangular factor R of a tall matrix A = Q R with columns scaled to length 1, by modified
/// Gram-Schmidt: as accurate as by Householder reflections (Bjorck 1967). Rows lie in lanes.
template <int Columns>
class TriangularFactor {
 public:
  /// Below this part of its length a column counts as a combination of the ones before it.
  static constexpr double dependent = 1e-6;

  /// Factorises the first `columns` columns, each of `packs` packs, one behind the other in `a`,
  /// which is used up. Returns the number of the first column that depends on earlier ones, or
  /// `columns` if none does.
  int factorise(std::vector<Lanes>& a, std::size_t packs, int columns) {
    columns_ = columns;
    for (int k = 0; k < columns; ++k) {
      Lanes* column = a.data() + static_cast<std::size_t>(k) * packs;
      scale_[k] = 1 / std::sqrt(dot(column, column, packs));
      if (!std::isfinite(scale_[k])) return k;
      for (std::size_t p = 0; p < packs; ++p) column[p] *= scale_[k];
    }
    for (int k = 0; k < columns; ++k) {
      Lanes* column = a.data() + static_cast<std::size_t>(k) * packs;
      r_[k][k] = std::sqrt(dot(column, column, packs));
      if (!(r_[k][k] > dependent)) return k;
      for (std::size_t p = 0; p < packs; ++p) column[p] *= 1 / r_[k][k];
      for (int l = k + 1; l < columns; ++l) {
        Lanes* other = a.data() + static_cast<std::size_t>(l) * packs;
        r_[k][l] = dot(column, other, packs);
        for (std::size_t p = 0; p < packs; ++p) other[p] -= r_[k][l] * column[p];
      }
    }
    return columns;
  }

  /// The solution c of A^T A c = e, by the two triangular systems; entries behind the factorised
  /// columns are 0.
  std::array<double, Columns> solve_normal_equations(std::array<double, Columns> e) const {
    for (int k = 0; k < columns_; ++k) {
      e[k] *= scale_[k];
      for (int l = 0; l < k; ++l) e[k] -= r_[l][k] * e[l];
      e[k] /= r_[k][k];
    }
    for (int k = columns_ - 1; k >= 0; --k) {
      for (int l = k + 1; l < columns_; ++l) e[k] -= r_[k][l] * e[l];
      e[k] /= r_[k][k];
    }
    for (int k = 0; k < Columns; ++k) e[k] = k < columns_ ? e[k] * scale_[k] : 0;
    return e;
  }

 private:
  static double dot(const Lanes* a, const Lanes* b, std::size_t packs) {
    Lanes sum = 0;
    for (std::size_t p = 0; p < packs; ++p) sum += a[p] * b[p];
    return sum_of(sum);
  }

  int columns_ = 0;
  std::array<double, Columns> scale_;
  std::array<std::array<double, Columns>, Columns> r_;
};

}  // namespace mote
