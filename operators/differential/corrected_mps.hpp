#pragma once

#include <string_view>

#include "mote/operators/differential/corrected_sph.hpp"
#include "mote/operators/weights/reciprocal.hpp"

namespace mote {

/// The moving particle semi-implicit method with its differences corrected by moment matrices
/// (Khayyer & Gotoh 2011, (8), for the gradient): CorrectedForm on F_ij = w_ij/r_ij^2, so that
///   g_ij = (sum_k w_ik e_ik e_ik^T)^-1 w_ij e_ij/r_ij,   e = x/r,
/// which is (70) where the neighbours lie evenly.
template <int D>
class CorrectedMps final : public CorrectedForm<D> {
 public:
  static constexpr std::string_view family = "corrected_mps";
  static constexpr std::string_view summary =
      "mps corrected by moment matrices: second derivatives exact for parabolas";
  using Weight = Reciprocal;

  /// A second ring of neighbours, without which they do not fix a parabola.
  double smoothing_length = Weight::usual_length + 0.6;  ///< in local spacings
  PairLength length = PairLength::mean;

  void describe(Description& description) override {
    describe_lengths(description, smoothing_length, length);
  }

  NeighbourRule neighbour_rule() const override {
    return {Weight::support, smoothing_length, length};
  }

 private:
  void find_slopes(Index i, std::span<Slope<D>> slopes) const override {
    const Points<D>& points = *this->points_;
    const auto list = (*this->lists_)[i];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Index j = list[k];
      const double h = smoothing_length * pair_length(length, points.length[i], points.length[j]);
      const Vec<D> x = points.at(j) - points.at(i);
      slopes[k] = {x, Weight::value(x.norm() / h) / x.squaredNorm()};
    }
  }
};

}  // namespace mote
