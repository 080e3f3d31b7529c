#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// Central differences on the ordered points of a line, of any spacing, and on lattices in 2 and 3
/// dimensions, of any spacing in each direction. Along a direction with the neighbours at the
/// signed distances a and b they are the three-point formulas that are exact for parabolas,
///   g_ij = b/(a (b - a)),   l_ij = 2/(a (a - b)),
/// and a mixed derivative is the product of two first ones, over the four corner points.
template <int D>
class FiniteDifference final : public DifferentialOperator<D> {
 public:
  static constexpr int highest_dimension = 3;
  static constexpr std::string_view family = "finite_difference";
  static constexpr std::string_view summary = "central differences on a line or a lattice";

  void describe(Description&) override {}
  NeighbourRule neighbour_rule() const override {
    // Far enough for the corners of a lattice cell with sides up to 2.5 to 1.
    return D == 1 ? NeighbourRule{.adjacent = 1} : NeighbourRule{.support = 2};
  }

  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
    sides_.resize(static_cast<std::size_t>(points.receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= points.receivers)
    for (Index i = 0; i < points.receivers; ++i) sides_[i] = sides_of(i);
    for (Index i = 0; i < points.receivers; ++i) refuse_missing_sides(i);
  }

  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    for (Vec<D>& weight : weights) weight.setZero();
    for (int d = 0; d < D; ++d)
      for (const auto& [k, own, other] : both_sides(i, d))
        weights[k][d] = other / (own * (other - own));
  }

  void laplacian_weights(Index i, std::span<double> weights) const override {
    for (double& weight : weights) weight = 0;
    for (int d = 0; d < D; ++d)
      for (const auto& [k, own, other] : both_sides(i, d)) weights[k] = 2 / (own * (own - other));
  }

  bool has_hessian() const override { return true; }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    for (Mat<D>& weight : weights) weight.setZero();
    for (int c = 0; c < D; ++c)
      for (const auto& first : both_sides(i, c)) {
        weights[first.k](c, c) = 2 / (first.own * (first.own - first.other));
        for (int d = 0; d < c; ++d)
          for (const auto& second : both_sides(i, d)) add_corner(i, {c, d}, first, second, weights);
      }
  }

 private:
  /// The neighbour next to a receiver on one side: its place in the list, and the signed distances
  /// of it and of the one on the other side.
  struct Side {
    std::size_t k;
    double own, other;
  };

  /// For each direction the places in the list of the neighbours below and above.
  using Sides = std::array<std::array<std::size_t, 2>, D>;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  Vec<D> to(Index i, std::size_t k) const { return points_->at((*lists_)[i][k]) - points_->at(i); }

  std::array<Side, 2> both_sides(Index i, int d) const {
    const auto [below, above] = sides_[i][d];
    const double a = to(i, below)[d], b = to(i, above)[d];
    return {{{below, a, b}, {above, b, a}}};
  }

  /// The nearest neighbour at `x` but for its component d, which has the sign of x[d] at least.
  Sides sides_of(Index i) const {
    Sides sides;
    for (auto& side : sides) side = {none, none};
    for (std::size_t k = 0; k < (*lists_)[i].size(); ++k) {
      const Vec<D> x = to(i, k);
      for (int d = 0; d < D; ++d) {
        Vec<D> aside = x;
        aside[d] = 0;
        if (!on_the_lattice(i, aside) || x[d] == 0) continue;
        std::size_t& side = sides[d][x[d] > 0];
        if (side == none || std::abs(x[d]) < std::abs(to(i, side)[d])) side = k;
      }
    }
    return sides;
  }

  /// Whether a distance is zero but for the rounding of positions.
  bool on_the_lattice(Index i, const Vec<D>& aside) const {
    constexpr double rounding = 1e-9;
    return aside.norm() <= rounding * points_->length[i];
  }

  void add_corner(Index i, std::array<int, 2> directions, const Side& first, const Side& second,
                  std::span<Mat<D>> weights) const {
    const auto [c, d] = directions;
    const double g = first.other / (first.own * (first.other - first.own)) * second.other /
                     (second.own * (second.other - second.own));
    const Vec<D> corner = to(i, first.k) + to(i, second.k);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      if (!on_the_lattice(i, to(i, k) - corner)) continue;
      weights[k](c, d) = weights[k](d, c) = g;
      // The product of two differences also has the points on the axes, and takes them away.
      for (const std::size_t axis : {first.k, second.k}) {
        weights[axis](c, d) -= g;
        weights[axis](d, c) -= g;
      }
      return;
    }
    throw NumericalFailure("particle " + std::to_string(i) + " lacks a corner of its lattice cell",
                           {i}, "mixed central differences need all points of a lattice");
  }

  void refuse_missing_sides(Index i) const {
    for (const auto& [below, above] : sides_[i])
      if (below == none || above == none)
        throw NumericalFailure(
            "particle " + std::to_string(i) + " has no point on each side", {i},
            D == 1 ? "central differences need a point on both sides of every particle"
                   : "central differences need the points of a lattice, and neighbours on both "
                     "sides of every particle in every direction");
  }

  const Points<D>* points_ = nullptr;
  const NeighbourLists* lists_ = nullptr;
  std::vector<Sides> sides_;
};

}  // namespace mote
