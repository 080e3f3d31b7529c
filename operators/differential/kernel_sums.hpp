#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/kernels/kernel.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Where rho_i comes from: the points bring it, or it is the sum (10) or (44) over the kernel.
enum class DensityFrom { points, summation };

/// The operators of Isshiki (2014), section 2, as printed, for any amount m_j and density rho_i of
/// what the kernel W smooths:
///   g_ij = (m_j/rho_i) W'_ij e_ij                                                        (28)
///   H_ij = (m_j/rho_i) [W''_ij e e^T + W'_ij/r_ij (1 - e e^T)
///                       - (W'_ij/rho_i) (e (grad rho)^T + (grad rho) e^T)]               (27)
///   l_ij = (m_j/rho_i) [W''_ij + (D-1) W'_ij/r_ij - (2/rho_i) W'_ij e_ij . (grad rho)_i]  (30)
///   (grad rho)_i = sum_k m_k W'_ik e_ik                                                  (20)
/// with e = e_ij = x_ij/r_ij. The double sums of (27), corrected where the print is garbled, and
/// (30) are products of two single sums.
///
/// `Smoothed` says what is smoothed: `amount(points)`, `density(points)`, and their words.
template <int D, class Kernel, class Smoothed>
class KernelSums : public DifferentialOperator<D> {
 public:
  static constexpr int highest_dimension = 3;

  double smoothing_length = Kernel::usual_length;  ///< in local spacings
  PairLength length = PairLength::mean;
  DensityFrom density_from = DensityFrom::points;
  Kernel kernel;

  void describe(Description& description) override {
    static constexpr Word<DensityFrom> sources[] = {
        {DensityFrom::points, "points", "the points bring it"},
        {DensityFrom::summation, "summation", "the sum over the kernel, (10) or (44)"}};
    describe_lengths(description, smoothing_length, length);
    describe_words(description, {"density", "where the density of a point comes from"},
                   density_from, sources);
    if constexpr (HasOptions<Kernel>) kernel.describe(description);
  }

  NeighbourRule neighbour_rule() const override {
    return {kernel.support(), smoothing_length, length};
  }

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    if (Smoothed::amount(points).size() != points.length.size())
      throw InputError("operator", Smoothed::lacking);
    points_ = &points;
    lists_ = &lists;
    density_.resize(static_cast<std::size_t>(points.receivers));
    density_gradient_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) sum_density(i);
    for (Index i = 0; i < points.receivers; ++i)
      if (points.needs_weights(i)) refuse_bad_sums(i);
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      weights[k] = amount(list[k]) / density_[i] * slope_over_r(pair) * pair.x;
    }
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      const double slope = slope_over_r(pair), squared = pair.x.squaredNorm();
      const double along = squared > 0 ? (curvature(pair) - slope) / squared : 0;
      const Mat<D> drift = slope / density_[i] * pair.x * density_gradient_[i].transpose();
      weights[k] = amount(list[k]) / density_[i] *
                   (along * pair.x * pair.x.transpose() + slope * Mat<D>::Identity() - drift -
                    drift.transpose());
    }
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    const auto list = (*lists_)[i];
    const double rho = density_[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      const double slope = slope_over_r(pair);
      weights[k] =
          amount(list[k]) / rho *
          (curvature(pair) + (D - 1) * slope - 2 / rho * slope * pair.x.dot(density_gradient_[i]));
    }
  }

 private:
  struct Pair {
    Vec<D> x;      ///< x_i - x_j
    double q;      ///< r/h
    double scale;  ///< 1/h^(D+2)
    double h;
  };

  Pair make_pair(Index i, Index j) const {
    const double h = smoothing_length * pair_length(length, points_->length[i], points_->length[j]);
    const Vec<D> x = points_->at(i) - points_->at(j);
    double volume = h;
    for (int d = 1; d < D; ++d) volume *= h;
    return {x, x.norm() / h, 1 / (volume * h * h), h};
  }

  /// W'(r)/r, W''(r) and W(r).
  double slope_over_r(const Pair& pair) const { return kernel.slope_over_q(pair.q) * pair.scale; }
  double curvature(const Pair& pair) const { return kernel.curvature(pair.q) * pair.scale; }
  double value(const Pair& pair) const {
    return kernel.value(pair.q) * pair.scale * pair.h * pair.h;
  }
  double amount(Index j) const { return Smoothed::amount(*points_)[j]; }

  void sum_density(Index i) {
    const bool given = density_from == DensityFrom::points;
    Vec<D> gradient = Vec<D>::Zero();
    double sum = given ? Smoothed::density(*points_)[i] : amount(i) * value(make_pair(i, i));
    for (const Index j : (*lists_)[i]) {
      const Pair pair = make_pair(i, j);
      gradient += amount(j) * slope_over_r(pair) * pair.x;
      if (!given) sum += amount(j) * value(pair);
    }
    density_[i] = sum;
    density_gradient_[i] = gradient;
  }

  void refuse_bad_sums(Index i) const {
    if (!density_gradient_[i].allFinite())
      throw NumericalFailure("the sums of particle " + std::to_string(i) + " are not finite", {i},
                             "another point lies at the same place");
    if (!std::isfinite(density_[i]) || density_[i] == 0)
      throw NumericalFailure(std::string("the ") + Smoothed::quantity + " of particle " +
                                 std::to_string(i) +
                                 (density_[i] == 0 ? " is 0" : " is not finite"),
                             {i}, "the operator divides by it");
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
  std::vector<double> density_;
  std::vector<Vec<D>> density_gradient_;
};

}  // namespace mote
