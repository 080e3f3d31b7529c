#include "mote/sums/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mote/operators/differential/lanes.hpp"

namespace mote {
namespace {

/// Parts of a tree of at least so many points are made by tasks of their own.
constexpr Index points_a_task = 8192;

/// A side shorter than this part of the longest one is not halved.
constexpr double long_side = 0.6;

/// The radius that points of one place get, relative to the distance of that place from others.
constexpr double radius_of_a_place = 1e-9;

}  // namespace

template <int D>
void PointTree<D>::build(std::span<const double> positions, Index leaf_capacity) {
  const auto count = static_cast<Index>(positions.size() / D);
  leaf_capacity_ = leaf_capacity;
  order_.resize(static_cast<std::size_t>(count));
  spare_order_.resize(order_.size());
  std::iota(order_.begin(), order_.end(), 0);
  for (std::size_t d = 0; d < D; ++d) {
    positions_[d].resize(order_.size() + lane_count);
    spare_positions_[d].resize(order_.size() + lane_count);
    for (std::size_t i = 0; i < order_.size(); ++i) positions_[d][i] = positions[D * i + d];
  }
  nodes_.clear();
#pragma omp parallel if (count >= points_a_task)
#pragma omp single
  if (count > 0) grow({0, count}, nodes_);
  if (count > 0 && nodes_[0].radius == 0)
    nodes_[0].radius = std::max(radius_of_a_place * nodes_[0].centre.norm(), 1e-150);
}

template <int D>
typename PointTree<D>::Box PointTree<D>::box_of(PointRange points) const {
  Box box;
  for (std::size_t d = 0; d < D; ++d) {
    const double* x = positions_[d].data();
    double lower = x[points.begin], upper = lower;
    for (Index i = points.begin; i < points.end; ++i) {
      lower = std::min(lower, x[i]);
      upper = std::max(upper, x[i]);
    }
    box.lower[d] = lower;
    box.upper[d] = upper;
  }
  return box;
}

/// Appends the tree over some points to `nodes`.
template <int D>
void PointTree<D>::grow(PointRange points, Nodes& nodes) {
  const Box box = box_of(points);
  const auto n = static_cast<Index>(nodes.size());
  const Vec<D> half = box.upper / 2 - box.lower / 2;
  nodes.push_back({box.lower + half, half.norm(), points, n + 1});
  if (points.count() <= leaf_capacity_ || half.maxCoeff() == 0) return enclose(nodes.back());
  const std::vector<PointRange> parts = split(points, box);
  if (parts.size() == 1) return enclose(nodes.back());  // no number lies between the two ends
  grow_children(parts, nodes);
  nodes[static_cast<std::size_t>(n)].next = static_cast<Index>(nodes.size());
  enclose_children(n, nodes);
}

template <int D>
void PointTree<D>::grow_children(std::span<const PointRange> parts, Nodes& nodes) {
  const bool few = parts.back().end - parts.front().begin < points_a_task;
  if (few) {
    for (const PointRange& part : parts) grow(part, nodes);
    return;
  }
  std::vector<Nodes> below(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
#pragma omp task shared(below, parts) firstprivate(k)
    grow(parts[k], below[k]);
#pragma omp taskwait
  for (const Nodes& part : below) {
    const auto offset = static_cast<Index>(nodes.size());
    for (Node node : part) {
      node.next += offset;
      nodes.push_back(node);
    }
  }
}

/// Where to halve a box: its long sides, the longest first, and no more of them than it takes to
/// come down to the capacity of a leaf. Sides that stay whole are cut at their end.
template <int D>
Vec<D> PointTree<D>::cuts(const Box& box, Index count) const {
  const Vec<D> half = box.upper / 2 - box.lower / 2;
  std::array<std::size_t, D> axes;
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  std::ranges::stable_sort(axes, [&](std::size_t a, std::size_t b) { return half[a] > half[b]; });
  Vec<D> cut = box.upper;
  Index capacity = leaf_capacity_;
  for (const std::size_t axis : axes) {
    if (capacity >= count || half[axis] < long_side * half.maxCoeff()) break;
    cut[axis] = box.lower[axis] + half[axis];
    capacity *= 2;
  }
  return cut;
}

/// Sorts the points by the halves that they lie in, keeping their order within each; returns the
/// parts that are not empty.
template <int D>
std::vector<PointRange> PointTree<D>::split(PointRange points, const Box& box) {
  constexpr std::size_t parts = 1 << D;
  const Vec<D> cut = cuts(box, points.count());
  const auto part_of = [&](Index i) {
    std::size_t part = 0;
    for (std::size_t d = 0; d < D; ++d)
      part |= static_cast<std::size_t>(positions_[d][static_cast<std::size_t>(i)] > cut[d]) << d;
    return part;
  };
  std::array<Index, parts> counts{};
  for (Index i = points.begin; i < points.end; ++i) ++counts[part_of(i)];
  std::array<Index, parts> place;
  std::exclusive_scan(counts.begin(), counts.end(), place.begin(), points.begin);
  std::vector<PointRange> ranges;
  for (std::size_t part = 0; part < parts; ++part)
    if (counts[part] > 0) ranges.push_back({place[part], place[part] + counts[part]});
  for (Index i = points.begin; i < points.end; ++i) {
    const auto from = static_cast<std::size_t>(i);
    const auto to = static_cast<std::size_t>(place[part_of(i)]++);
    for (std::size_t d = 0; d < D; ++d) spare_positions_[d][to] = positions_[d][from];
    spare_order_[to] = order_[from];
  }
  for (std::size_t d = 0; d < D; ++d)
    std::copy(spare_positions_[d].begin() + points.begin, spare_positions_[d].begin() + points.end,
              positions_[d].begin() + points.begin);
  std::copy(spare_order_.begin() + points.begin, spare_order_.begin() + points.end,
            order_.begin() + points.begin);
  return ranges;
}

/// The distance of the farthest point from a leaf's centre.
template <int D>
void PointTree<D>::enclose(Node& leaf) const {
  double farthest = 0;
  for (Index i = leaf.points.begin; i < leaf.points.end; ++i) {
    double squared = 0;
    for (std::size_t d = 0; d < D; ++d) {
      const double difference = positions_[d][static_cast<std::size_t>(i)] - leaf.centre[d];
      squared += difference * difference;
    }
    farthest = std::max(farthest, squared);
  }
  leaf.radius = std::sqrt(farthest);
}

/// The balls of the children bound that of their parent too, often closer than its box does. Here
/// children of one place get a radius, as nobody below needs theirs any more.
template <int D>
void PointTree<D>::enclose_children(Index n, Nodes& nodes) {
  Node& parent = nodes[static_cast<std::size_t>(n)];
  double reach = 0;
  for (Index c = n + 1; c < parent.next; c = nodes[static_cast<std::size_t>(c)].next) {
    Node& child = nodes[static_cast<std::size_t>(c)];
    child.radius = std::max(child.radius, radius_of_a_place * parent.radius);
    reach = std::max(reach, (child.centre - parent.centre).norm() + child.radius);
  }
  parent.radius = std::min(parent.radius, reach);
}

template class PointTree<2>;
template class PointTree<3>;

}  // namespace mote
