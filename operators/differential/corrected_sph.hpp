#pragma once

#include <string_view>
#include <vector>

#include "mote/operators/differential/difference_form.hpp"
#include "mote/operators/differential/moment_correction.hpp"

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
template <int D>
class CorrectedForm : public DifferenceForm<D> {
 public:
  void prepare(const Points<D>& points, const NeighbourLists& lists) override;
  void gradient_weights(Index i, std::span<Vec<D>> weights) const override;
  void laplacian_weights(Index i, std::span<double> weights) const override;
  void both_weights(Index i, std::span<Vec<D>> gradient,
                    std::span<double> laplacian) const override;
  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override;

 private:
  void refuse_bad_neighbourhood(Index i) const;

  std::vector<MomentCorrection<D>> corrections_;
};

extern template class CorrectedForm<1>;
extern template class CorrectedForm<2>;
extern template class CorrectedForm<3>;

template <int D, class Kernel>
class CorrectedSph final : public OnSlopes<CorrectedForm<D>, D, Kernel> {
 public:
  static constexpr std::string_view family = "corrected_sph";
  static constexpr std::string_view summary =
      "sph corrected by moment matrices: second derivatives exact for parabolas";
};

}  // namespace mote
