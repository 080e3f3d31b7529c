#pragma once

#include <span>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/kernels/kernel.hpp"

namespace mote {

/// A neighbour as a difference form sees it.
template <int D>
struct Slope {
  Vec<D> x;       ///< x_j - x_i
  double weight;  ///< F_ij
};

/// What the families share that weight differences by the slope of a kernel (Brookshaw 1985),
///   F_ij = -V_j W'_ij/r_ij   with the volume V_j = m_j/rho_j.
/// A form is written over the slopes of a whole row, whatever the kernel: one virtual call a row,
/// and its matrices are compiled once.
template <int D>
class DifferenceForm : public DifferentialOperator<D> {
 public:
  static constexpr int highest_dimension = 3;

 protected:
  /// The slopes of receiver i to its neighbours in list order, in room that belongs to the thread
  /// and holds until the next call.
  std::span<const Slope<D>> slopes_of(Index i) const {
    static thread_local std::vector<Slope<D>> room;
    const std::size_t count = (*lists_)[i].size();
    if (room.size() < count) room.resize(2 * count);
    const std::span<Slope<D>> slopes = std::span(room).first(count);
    find_slopes(i, slopes);
    return slopes;
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;

 private:
  virtual void find_slopes(Index i, std::span<Slope<D>> slopes) const = 0;
};

/// A difference form on a kernel.
template <class Form, int D, class Kernel>
class OnSlopes : public Form {
  static_assert(SmoothingKernel<Kernel>);

 public:
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

 private:
  void find_slopes(Index i, std::span<Slope<D>> slopes) const override {
    const Points<D>& points = *this->points_;
    const auto list = (*this->lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Index j = list[k];
      const double h = smoothing_length * pair_length(length, points.length[i], points.length[j]);
      const Vec<D> x = points.at(j) - points.at(i);
      double scale = h * h;
      for (int d = 0; d < D; ++d) scale *= h;
      const double volume = points.mass[j] / points.density[j];
      slopes[k] = {x, -volume / scale * kernel.slope_over_q(x.norm() / h)};
    }
  }
};

}  // namespace mote
