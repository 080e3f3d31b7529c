#pragma once

#include <span>
#include <vector>

#include "mote/integrators/rows.hpp"

namespace mote {

/// Where a polynomial is given by its value and this many derivatives.
struct HermiteNode {
  double time;
  int derivatives;
};

/// What a value or a derivative at a node counts for in a polynomial's value and rate of change.
struct HermiteWeight {
  double value, rate;
};

/// The polynomial P through values y_j and derivatives y_j', ... at nodes t_j, at one time t, as
/// sums over what is known at the nodes:
///   P(t) = sum_jk w_jk y_j^(k),   P'(t) = sum_jk w'_jk y_j^(k).
/// The weights are Newton's divided differences with repeated nodes (Rehman 2014, 1.1.1; for one
/// step the same numbers as his 1.1.2 and 1.1.3), with long double rounding, so that nearly nothing
/// is lost. They serve every component of a system.
///
/// At t = t_j, P and P' are y_j and y_j' to the bit. To lose nothing where values are larger than
/// their changes, use the weights on differences from the value at `nearest`: those of values add
/// to 1.
class HermiteWeights {
 public:
  /// For one or more nodes at different times.
  HermiteWeights(std::span<const HermiteNode> nodes, double time);

  /// Of the value and the derivatives at a node, from order 0 on.
  const std::vector<HermiteWeight>& at(std::size_t node) const { return weight_[node]; }

  /// The node whose time is nearest.
  std::size_t nearest() const { return nearest_; }

 private:
  std::vector<std::vector<HermiteWeight>> weight_;
  std::size_t nearest_;
};

/// A node with what is known there: a row of values, and one for each derivative.
struct KnownNode {
  double time;
  std::vector<Row> derivative;
};

/// Values and rates of change of the polynomials through such nodes.
struct Interpolated {
  Row value, rate;
};
Interpolated interpolate(std::span<const KnownNode> nodes, double time);

}  // namespace mote
