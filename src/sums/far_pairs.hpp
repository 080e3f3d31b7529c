#pragma once

#include <array>

#include "mote/sums/point_tree.hpp"

namespace mote {

/// A source node far enough from a target node for expansions of `degree` terms, of source and
/// target.
template <int D>
struct FarPair {
  const double* series;            ///< of the source node
  std::array<double, D> distance;  ///< from the source node's centre to the target node's
  double radius;                   ///< of the source node
  int degree;
};

/// A child of a node, and its series.
template <int D>
struct Child {
  const TreeNode<D>& node;
  double* series;
};

}  // namespace mote
