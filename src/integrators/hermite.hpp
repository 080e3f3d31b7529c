#pragma once

#include <array>
#include <span>

namespace mote {

/// The most nodes, and derivatives at each, that a Hermite polynomial of mote goes through.
constexpr int most_hermite_nodes = 4, most_hermite_derivatives = 2;

/// What a value or a derivative at a node counts for in a polynomial's value and rate of change.
struct HermiteWeight {
  double value, rate;
};

/// The polynomial P through values y_j and derivatives y_j', ... at nodes t_j, at one time t, as
/// sums over what is known at the nodes:
///   P(t) = sum_jk weight(j, k).value y_j^(k),   P'(t) = sum_jk weight(j, k).rate y_j^(k).
/// The weights are Newton's divided differences with repeated nodes (Rehman 2014, 1.1.1; for one
/// step the same numbers as his 1.1.2 and 1.1.3), with long double rounding, so that nearly nothing
/// is lost. They serve every component of a system.
///
/// At t = t_j, P and P' are y_j and y_j' to the bit. To lose nothing where values are larger than
/// their changes, use the weights on differences from `nearest`: the weights of values add to 1.
class HermiteWeights {
 public:
  /// For nodes at 1 to `most_hermite_nodes` different times, and as many derivatives at each.
  HermiteWeights(std::span<const double> times, int derivatives, double time);

  /// Of derivative `order` (0: the value) at a node, by its place in `times`.
  const HermiteWeight& weight(int node, int order) const { return weight_[node][order]; }

  /// The node whose time is nearest.
  int nearest() const { return nearest_; }

 private:
  std::array<std::array<HermiteWeight, most_hermite_derivatives + 1>, most_hermite_nodes> weight_{};
  int nearest_ = 0;
};

}  // namespace mote
