#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// Numbers of many points, component by component, with room for a pack of lanes behind the last.
template <int C>
using Columns = std::array<std::vector<double>, C>;

/// A part of the points, in their order in the tree.
struct PointRange {
  Index begin = 0, end = 0;
  Index count() const { return end - begin; }
};

/// A box of points that lie side by side in the tree's order, all within `radius` of `centre`;
/// the radius is above 0 even for points of one place, so that it can be a unit of length.
/// Nodes stand before their children: the first child is the next node, and `next` is the first
/// node that is not below this one, the next child of its parent or of an elder.
template <int D>
struct TreeNode {
  Vec<D> centre;
  double radius;
  PointRange points;
  Index next;
};

/// An adaptive tree over any points: boxes are halved along their long sides where they hold more
/// than `leaf_capacity` points that are not all in one place, and are shrunk to what they hold.
/// So its depth follows the points, at any scale. It is the same for any number of threads.
template <int D>
class PointTree {
 public:
  using Node = TreeNode<D>;

  /// `positions`: D numbers a point.
  void build(std::span<const double> positions, Index leaf_capacity);

  Index count() const { return static_cast<Index>(order_.size()); }
  std::span<const Node> nodes() const { return nodes_; }
  const Node& node(Index n) const { return nodes_[static_cast<std::size_t>(n)]; }
  bool is_leaf(Index n) const { return node(n).next == n + 1; }
  /// Which point stands at each place of the tree's order, and where.
  std::span<const Index> order() const { return order_; }
  const Columns<D>& positions() const { return positions_; }

  /// Calls `visit(child)` for the children of a node, in order.
  template <class Visit>
  void for_each_child(Index n, Visit visit) const {
    for (Index child = n + 1; child < node(n).next; child = node(child).next) visit(child);
  }

 private:
  struct Box {
    Vec<D> lower, upper;
  };
  using Nodes = std::vector<Node>;

  Box box_of(PointRange points) const;
  void grow(PointRange points, Nodes& nodes);
  void grow_children(std::span<const PointRange> parts, Nodes& nodes);
  Vec<D> cuts(const Box& box, Index count) const;
  std::vector<PointRange> split(PointRange points, const Box& box);
  void enclose(Node& leaf) const;
  static void enclose_children(Index n, Nodes& nodes);

  Nodes nodes_;
  std::vector<Index> order_, spare_order_;
  Columns<D> positions_, spare_positions_;
  Index leaf_capacity_ = 1;
};

extern template class PointTree<2>;
extern template class PointTree<3>;

}  // namespace mote
