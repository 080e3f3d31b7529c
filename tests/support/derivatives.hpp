#pragma once

#include <vector>

#include "mote/operators/differential/apply.hpp"
#include "support/brute_force.hpp"

namespace mote::test {

/// What an operator makes of a scalar and a vector field, at every receiver.
struct Derivatives {
  std::vector<double> gradient, divergence, laplacian;
};

/// Applies `op` to `scalar` (one number a point) and `vector` (D numbers a point), with neighbours
/// found by brute force.
template <int D>
Derivatives derivatives_of(DifferentialOperator<D>& op, const Points<D>& points,
                           const std::vector<double>& scalar, const std::vector<double>& vector) {
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  const auto receivers = static_cast<std::size_t>(points.receivers);
  Derivatives result{std::vector<double>(receivers * D), std::vector<double>(receivers),
                     std::vector<double>(receivers)};
  op.prepare(points, lists);
  gradient<D>(op, lists, scalar, result.gradient);
  divergence<D>(op, lists, vector, result.divergence);
  laplacian<D>(op, lists, scalar, result.laplacian);
  return result;
}

}  // namespace mote::test
