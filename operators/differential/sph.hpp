#pragma once

#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// Smoothed particle hydrodynamics as printed (Isshiki 2014):
///   g_ij = (m_j/rho_i) W'_ij e_ij                                                        (28)
///   l_ij = (m_j/rho_i) [W''_ij + (D-1) W'_ij/r_ij - (2/rho_i) W'_ij e_ij . (grad rho)_i]  (30)
///   (grad rho)_i = sum_k m_k W'_ik e_ik                                                  (20)
/// with e_ij = x_ij/r_ij. The double sum of (30) is the product of two single sums. rho is the
/// particles' density, not a sum over the kernel.
template <int D, class Kernel>
class Sph final : public DifferentialOperator<D> {
  static_assert(SmoothingKernel<Kernel>);

 public:
  static constexpr int highest_dimension = 3;
  static constexpr std::string_view family = "sph";
  static constexpr std::string_view summary =
      "smoothed particle hydrodynamics as printed, (28) and (30)";

  double smoothing_length = Kernel::usual_length;  ///< in local spacings
  PairLength length = PairLength::mean;
  Kernel kernel;

  void describe(Description& description) override {
    describe_lengths(description, smoothing_length, length);
    if constexpr (HasOptions<Kernel>) kernel.describe(description);
  }

  NeighbourRule neighbour_rule() const override {
    return {kernel.support(), smoothing_length, length};
  }

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    density_gradient_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) {
      Vec<D> sum = Vec<D>::Zero();
      for (const Index j : lists[i]) {
        const Pair pair = make_pair(i, j);
        sum += points.mass[j] * slope_over_r(pair) * pair.x;
      }
      density_gradient_[i] = sum;
    }
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      weights[k] = points_->mass[list[k]] / points_->density[i] * slope_over_r(pair) * pair.x;
    }
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    const auto list = (*lists_)[i];
    const double rho = points_->density[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      const double curvature = kernel.curvature(pair.q) * pair.scale;
      const double slope = slope_over_r(pair);
      weights[k] =
          points_->mass[list[k]] / rho *
          (curvature + (D - 1) * slope - 2 / rho * slope * pair.x.dot(density_gradient_[i]));
    }
  }

 private:
  struct Pair {
    Vec<D> x;      ///< x_i - x_j
    double q;      ///< r/h
    double scale;  ///< 1/h^(D+2)
  };

  Pair make_pair(Index i, Index j) const {
    const double h = smoothing_length * pair_length(length, points_->length[i], points_->length[j]);
    const Vec<D> x = points_->at(i) - points_->at(j);
    double volume = h;
    for (int d = 1; d < D; ++d) volume *= h;
    return {x, x.norm() / h, 1 / (volume * h * h)};
  }

  /// W'(r)/r.
  double slope_over_r(const Pair& pair) const { return kernel.slope_over_q(pair.q) * pair.scale; }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
  std::vector<Vec<D>> density_gradient_;
};

}  // namespace mote
