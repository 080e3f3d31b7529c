#pragma once

#include <string>
#include <string_view>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Central differences on the ordered points of a line, of any spacing: the three-point formulas
/// that are exact for parabolas. With a = x_j - x_i of one neighbour and b that of the other,
///   g_ij = b/(a (b - a)),   l_ij = 2/(a (a - b)).
template <int D>
class FiniteDifference final : public DifferentialOperator<D> {
  static_assert(D == 1);

 public:
  static constexpr int highest_dimension = 1;
  static constexpr std::string_view family = "finite_difference";
  static constexpr std::string_view summary = "central differences on a line";

  void describe(Description&) override {}
  NeighbourRule neighbour_rule() const override { return {.adjacent = 1}; }

  void prepare(const Points<1>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    for (Index i = 0; i < points.receivers; ++i) {
      if (lists[i].size() == 2 && spacing(i, 0) * spacing(i, 1) < 0) continue;
      throw NumericalFailure("particle " + std::to_string(i) + " has no point on each side", {i},
                             "central differences need a point on both sides of every particle");
    }
  }

  void gradient_weights(Index i, std::span<Vec<1>> weights) const override {
    // With signed distances a, b to the two neighbours the formulas are the same for both.
    const double a = spacing(i, 0), b = spacing(i, 1);
    weights[0][0] = b / (a * (b - a));
    weights[1][0] = a / (b * (a - b));
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    const double a = spacing(i, 0), b = spacing(i, 1);
    weights[0] = 2 / (a * (a - b));
    weights[1] = 2 / (b * (b - a));
  }

 private:
  /// x_j - x_i of the k-th neighbour.
  double spacing(Index i, std::size_t k) const {
    return points_->position[(*lists_)[i][k]] - points_->position[i];
  }

  const Points<1>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
};

}  // namespace mote
