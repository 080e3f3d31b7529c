#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/difference_form.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// The difference form of the SPH Laplacian (Brookshaw 1985; Morris, Fox & Zhu 1997), normalised.
/// With x = x_j - x_i and the slopes F_ij of DifferenceForm,
///   g_ij = D/S_i F_ij x,   l_ij = 2 D/S_i F_ij,   S_i = sum_j F_ij r_ij^2,
/// where S_i, which is D in the limit of many neighbours, makes the Laplacian of r^2 right whatever
/// the neighbours are. Nothing is solved, and on points in regular order, however stretched, it
/// converges with order 2; at random points it is not exact for linear fields. The Hessian is that
/// of Espanol & Revenga (2003), whose trace is l_ij:
///   H_ij = D/S_i F_ij [(D+2) e e^T - 1],   e = x/r.
template <int D, class Kernel>
class Morris final : public DifferenceForm<D, Kernel> {
 public:
  static constexpr std::string_view family = "morris";
  static constexpr std::string_view summary =
      "sph with the difference form of Morris (1997), normalised by its second moment";

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    scale_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) {
      double sum = 0;
      for (const Index j : lists[i]) {
        const auto [x, slope] = make_pair(i, j);
        sum += slope * x.squaredNorm();
      }
      scale_[i] = D / sum;
    }
    for (Index i = 0; i < points.receivers; ++i) refuse_bad_neighbourhood(i);
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto [x, slope] = make_pair(i, list[k]);
      weights[k] = scale_[i] * slope * x;
    }
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k)
      weights[k] = 2 * scale_[i] * make_pair(i, list[k]).slope;
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    const auto list = (*lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto [x, slope] = make_pair(i, list[k]);
      const Vec<D> e = x.normalized();
      weights[k] = scale_[i] * slope * ((D + 2) * e * e.transpose() - Mat<D>::Identity());
    }
  }

 private:
  using Base = DifferenceForm<D, Kernel>;
  using Base::points_, Base::lists_, Base::make_pair;

  void refuse_bad_neighbourhood(Index i) const {
    if (std::isfinite(scale_[i])) return;
    throw NumericalFailure(
        "particle " + std::to_string(i) + " has " + std::to_string((*lists_)[i].size()) +
            " neighbours, and the second moment of their weights is 0 or not finite",
        {i}, "no other point lies within the support, or one is at the same place");
  }

  std::vector<double> scale_;  ///< D/S_i
};

}  // namespace mote
