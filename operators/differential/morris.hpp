#pragma once

#include <string_view>
#include <vector>

#include "mote/operators/differential/difference_form.hpp"

namespace mote {

/// The difference form of the SPH Laplacian (Brookshaw 1985; Morris, Fox & Zhu 1997), normalised.
/// With x = x_j - x_i and the slopes F_ij of DifferenceForm,
///   g_ij = D/S_i F_ij x,   l_ij = 2 D/S_i F_ij,   S_i = sum_j F_ij r_ij^2,
/// where S_i, which is D in the limit of many neighbours, makes the Laplacian of r^2 right whatever
/// the neighbours are. Nothing is solved, and on points in regular order, however stretched, it
/// converges with order 2; at random points it is not exact for linear fields. The Hessian is that
/// of Espanol & Revenga (2003), whose trace is l_ij:
///   H_ij = D/S_i F_ij [(D+2) e e^T - 1],   e = x/r.
template <int D>
class MorrisForm : public DifferenceForm<D> {
 public:
  void prepare(const Points<D>& points, const NeighbourLists& lists) override;
  void gradient_weights(Index i, std::span<Vec<D>> weights) const override;
  void laplacian_weights(Index i, std::span<double> weights) const override;
  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override;

 private:
  void refuse_bad_neighbourhood(Index i) const;

  std::vector<double> scale_;  ///< D/S_i
};

extern template class MorrisForm<1>;
extern template class MorrisForm<2>;
extern template class MorrisForm<3>;

template <int D, class Kernel>
class Morris final : public OnSlopes<MorrisForm<D>, D, Kernel> {
 public:
  static constexpr std::string_view family = "morris";
  static constexpr std::string_view summary =
      "sph with the difference form of Morris (1997), normalised by its second moment";
};

}  // namespace mote
