#pragma once

#include <Eigen/LU>
#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/differential/monomials.hpp"
#include "mote/operators/kernels/kernel.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Smoothed particle hydrodynamics with a gradient that is exact for linear fields and second
/// derivatives that are exact for parabolas, at any arrangement of the points.
/// With x = x_j - x_i, F_ij = -V_j W'_ij/r_ij and the volume V_j = m_j/rho_j,
///   g_ij = B_i F_ij x,   B_i^-1 = sum_j F_ij x x^T
/// after Bonet & Lok (1999), exact for linear fields, and the Laplacian of Brookshaw (1985) and
/// Morris (1997), 2 F_ij (f_j - f_i), with the two corrections of Fatehi & Manzari (2011): a tensor
/// A_i in place of the number 2, and what a linear field would give taken away,
///   l_ij = F_ij (e^T A_i e - x . B_i sum_k F_ik (e_ik^T A_i e_ik) x_ik),   e = x/r,
/// where A_i follows from the D(D+1)/2 conditions sum_j l_ij x x^T = 2. The Hessian has one such
/// tensor a component.
template <int D, class Kernel>
class CorrectedSph final : public DifferentialOperator<D> {
  static_assert(SmoothingKernel<Kernel>);
  static constexpr int second = second_derivatives<D>;
  using Tensor = Eigen::Matrix<double, second, 1>;  ///< A as xx, 2 xy, 2 xz, yy, 2 yz, zz

 public:
  static constexpr int highest_dimension = 3;
  static constexpr std::string_view family = "corrected_sph";
  static constexpr std::string_view summary =
      "sph corrected by moment matrices: second derivatives exact for parabolas";

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
    corrections_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) corrections_[i] = correction_of(i);
    for (Index i = 0; i < points.receivers; ++i) refuse_bad_neighbourhood(i);
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      weights[k] = corrections_[i].gradient * (pair.slope * pair.x);
    }
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    const auto list = (*lists_)[i];
    const auto& [gradient, tensor, offset] = corrections_[i];
    for (std::size_t k = 0; k < list.size(); ++k)
      weights[k] = second_weight(make_pair(i, list[k]), tensor, offset);
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    const auto list = (*lists_)[i];
    const Moments moments = moments_of(i);
    const Mat<D> gradient = moments.first.inverse();
    const auto solver = moments.conditions(gradient).fullPivLu();
    int s = 0;
    for (int c = 0; c < D; ++c)
      for (int d = c; d < D; ++d, ++s) {
        // sum_j H_ij x_c x_d is 2 for a diagonal component, and 1 for the others.
        const Tensor tensor = solver.solve(Tensor::Unit(s) * (c == d ? 2 : 1));
        const Vec<D> offset = gradient * (moments.mixed * tensor);
        for (std::size_t k = 0; k < list.size(); ++k)
          weights[k](c, d) = weights[k](d, c) =
              second_weight(make_pair(i, list[k]), tensor, offset);
      }
  }

 private:
  struct Pair {
    Vec<D> x;      ///< x_j - x_i
    double slope;  ///< F_ij
  };

  /// The sums over the neighbours of a receiver; y stands for the products x_c x_d.
  struct Moments {
    Mat<D> first = Mat<D>::Zero();                                 ///< sum F x x^T
    Eigen::Matrix<double, D, second> mixed = mixed.Zero();         ///< sum F/r^2 x y^T
    Eigen::Matrix<double, D, second> third = third.Zero();         ///< sum F x y^T
    Eigen::Matrix<double, second, second> fourth = fourth.Zero();  ///< sum F/r^2 y y^T

    /// The matrix of the conditions on a tensor: sum_j (its second weights) y.
    Eigen::Matrix<double, second, second> conditions(const Mat<D>& gradient) const {
      return fourth - third.transpose() * gradient * mixed;
    }
  };

  /// What prepare() finds for a receiver: B, the Laplacian's A, and what its linear part is.
  struct Correction {
    Mat<D> gradient;
    Tensor tensor;
    Vec<D> offset;
  };

  Pair make_pair(Index i, Index j) const {
    const double h = smoothing_length * pair_length(length, points_->length[i], points_->length[j]);
    const Vec<D> x = points_->at(j) - points_->at(i);
    double scale = h * h;
    for (int d = 0; d < D; ++d) scale *= h;
    const double volume = points_->mass[j] / points_->density[j];
    return {x, -volume / scale * kernel.slope_over_q(x.norm() / h)};
  }

  static double second_weight(const Pair& pair, const Tensor& tensor, const Vec<D>& offset) {
    return pair.slope *
           (tensor.dot(products_of<D>(pair.x)) / pair.x.squaredNorm() - pair.x.dot(offset));
  }

  Moments moments_of(Index i) const {
    Moments sum;
    for (const Index j : (*lists_)[i]) {
      const auto [x, slope] = make_pair(i, j);
      const Tensor y = products_of<D>(x);
      const Vec<D> weighted = slope * x;
      const double over_square = 1 / x.squaredNorm();
      sum.first += weighted * x.transpose();
      sum.third += weighted * y.transpose();
      sum.mixed += (over_square * weighted) * y.transpose();
      sum.fourth += (over_square * slope * y) * y.transpose();
    }
    return sum;
  }

  Correction correction_of(Index i) const {
    // Below this the points lie on fewer directions than there are derivatives to find.
    constexpr double singular = 1e-10;
    const Moments moments = moments_of(i);
    auto first = moments.first.fullPivLu();
    first.setThreshold(singular);
    const Mat<D> gradient = first.inverse();
    const auto conditions = moments.conditions(gradient).fullPivLu();
    // The conditions are a difference: what is left of it counts against what it was taken from.
    const double least = conditions.matrixLU().diagonal().cwiseAbs().minCoeff();
    if (!first.isInvertible() || !(least > singular * moments.fourth.cwiseAbs().maxCoeff()))
      return {Mat<D>::Constant(std::nan("")), {}, {}};
    const Tensor tensor = conditions.solve(2 * products_of_unity());
    return {gradient, tensor, gradient * (moments.mixed * tensor)};
  }

  /// The unit matrix as a tensor.
  static Tensor products_of_unity() {
    Tensor unity = Tensor::Zero();
    for (int d = 0; d < D; ++d) unity += products_of<D>(Vec<D>::Unit(d));
    return unity;
  }

  void refuse_bad_neighbourhood(Index i) const {
    if (corrections_[i].gradient.allFinite() && corrections_[i].tensor.allFinite()) return;
    throw NumericalFailure(
        "particle " + std::to_string(i) + " has " + std::to_string((*lists_)[i].size()) +
            " neighbours, and their moment matrix is singular",
        {i}, "they are too few, at the same place, or on too few directions for a parabola");
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
  std::vector<Correction> corrections_;
};

}  // namespace mote
