#pragma once

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// What the families share that weight differences by the slope of a kernel (Brookshaw 1985),
///   F_ij = -V_j W'_ij/r_ij   with the volume V_j = m_j/rho_j.
template <int D, class Kernel>
class DifferenceForm : public DifferentialOperator<D> {
  static_assert(SmoothingKernel<Kernel>);

 public:
  static constexpr int highest_dimension = 3;

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

 protected:
  struct Pair {
    Vec<D> x;      ///< x_j - x_i
    double slope;  ///< F_ij
  };

  Pair make_pair(Index i, Index j) const {
    const double h = smoothing_length * pair_length(length, points_->length[i], points_->length[j]);
    const Vec<D> x = points_->at(j) - points_->at(i);
    double scale = h * h;
    for (int d = 0; d < D; ++d) scale *= h;
    const double volume = points_->mass[j] / points_->density[j];
    return {x, -volume / scale * kernel.slope_over_q(x.norm() / h)};
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
};

}  // namespace mote
