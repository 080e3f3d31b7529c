#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/difference_form.hpp"
#include "mote/operators/differential/moment_correction.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Smoothed particle hydrodynamics with a gradient that is exact for linear fields and second
/// derivatives that are exact for parabolas, at any arrangement of the points.
/// With x = x_j - x_i and the slopes F_ij of DifferenceForm,
///   g_ij = B_i F_ij x,   B_i^-1 = sum_j F_ij x x^T
/// after Bonet & Lok (1999), exact for linear fields, and the Laplacian of Brookshaw (1985) and
/// Morris (1997), 2 F_ij (f_j - f_i), with the two corrections of Fatehi & Manzari (2011): a tensor
/// A_i in place of the number 2, and what a linear field would give taken away,
///   l_ij = F_ij (e^T A_i e - x . B_i sum_k F_ik (e_ik^T A_i e_ik) x_ik),   e = x/r,
/// where A_i follows from the D(D+1)/2 conditions sum_j l_ij x x^T = 2. The Hessian has one such
/// tensor a component.
template <int D, class Kernel>
class CorrectedSph final : public DifferenceForm<D, Kernel> {
 public:
  static constexpr std::string_view family = "corrected_sph";
  static constexpr std::string_view summary =
      "sph corrected by moment matrices: second derivatives exact for parabolas";

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    corrections_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) corrections_[i] = correction_of(moments_of(i));
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
    for (std::size_t k = 0; k < list.size(); ++k)
      weights[k] = second_weight(make_pair(i, list[k]), corrections_[i].laplacian);
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    const auto list = (*lists_)[i];
    const auto components = hessian_of(moments_of(i));
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Pair pair = make_pair(i, list[k]);
      int s = 0;
      for (int c = 0; c < D; ++c)
        for (int d = c; d < D; ++d)
          weights[k](c, d) = weights[k](d, c) = second_weight(pair, components[s++]);
    }
  }

 private:
  using Base = DifferenceForm<D, Kernel>;
  using Base::points_, Base::lists_, Base::make_pair;
  using Pair = typename Base::Pair;

  static double second_weight(const Pair& pair, const SecondDerivative<D>& derivative) {
    return pair.slope * (derivative.tensor.dot(products_of<D>(pair.x)) / pair.x.squaredNorm() -
                         pair.x.dot(derivative.offset));
  }

  Moments<D> moments_of(Index i) const {
    Moments<D> sum;
    for (const Index j : (*lists_)[i]) {
      const auto [x, slope] = make_pair(i, j);
      sum.add(x, slope);
    }
    return sum;
  }

  void refuse_bad_neighbourhood(Index i) const {
    if (corrections_[i].exists()) return;
    throw NumericalFailure(
        "particle " + std::to_string(i) + " has " + std::to_string((*lists_)[i].size()) +
            " neighbours, and their moment matrix is singular",
        {i}, "they are too few, at the same place, or on too few directions for a parabola");
  }

  std::vector<MomentCorrection<D>> corrections_;
};

}  // namespace mote
