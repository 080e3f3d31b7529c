#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mote/operators/differential/differential_operator.hpp"

namespace mote::test {

/// An operator of which the largest weight of one receiver, or of every one, is wrong by a part:
/// what a check must notice.
template <int D, class Right>
class AlteredOperator final : public DifferentialOperator<D> {
 public:
  AlteredOperator(Right right, std::optional<Index> receiver, double part)
      : right_(std::move(right)), receiver_(receiver), factor_(1 + part) {}

  void describe(Description& description) override { right_.describe(description); }
  NeighbourRule neighbour_rule() const override { return right_.neighbour_rule(); }
  void prepare(const Points<D>& points, const NeighbourLists& lists) override {
    right_.prepare(points, lists);
  }
  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    right_.gradient_weights(i, weights);
    if (receiver_ && i != *receiver_) return;
    *std::ranges::max_element(weights, {}, [](const Vec<D>& g) { return g.norm(); }) *= factor_;
  }
  void laplacian_weights(Index i, std::span<double> weights) const override {
    right_.laplacian_weights(i, weights);
    if (receiver_ && i != *receiver_) return;
    *std::ranges::max_element(weights, {}, [](double l) { return std::abs(l); }) *= factor_;
  }
  bool has_hessian() const override { return right_.has_hessian(); }
  void hessian_weights(Index i, std::span<Mat<D>> weights) const override {
    right_.hessian_weights(i, weights);
    if (receiver_ && i != *receiver_) return;
    *std::ranges::max_element(weights, {}, [](const Mat<D>& h) { return h.norm(); }) *= factor_;
  }

 private:
  Right right_;
  std::optional<Index> receiver_;
  double factor_;
};

}  // namespace mote::test
