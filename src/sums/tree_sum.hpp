#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/particles/parallel.hpp"
#include "mote/sums/complex_lanes.hpp"
#include "mote/sums/multipole_sum.hpp"
#include "mote/sums/pair_loop.hpp"
#include "mote/sums/point_tree.hpp"

namespace mote {

/// What a pair kernel looks like from afar: the expansion of its field, and eight of its values at
/// places near a node's centre (`place` is in units of the node's radius) from a Taylor series.
template <class F, class K>
concept FarField = PairKernel<K> &&
    requires(const F& far, const double* taylor, double radius,
             const std::array<Lanes, K::dimension>& place, std::array<Lanes, K::outputs>& sums) {
  { far.expansion().size() } -> std::same_as<std::size_t>;
  { far.add(taylor, radius, place, sums) } -> std::same_as<void>;
};

/// The sum of a pair kernel over all pairs by the fast multipole method. Keeps its memory.
template <PairKernel K, FarField<K> Far>
class TreeSum {
 public:
  TreeSum(Far far, Index leaf_capacity) : far_(std::move(far)), leaf_capacity_(leaf_capacity) {}

  /// Sums at the targets, or at the sources if `targets` is empty: K::dimension numbers a point,
  /// K::strengths numbers a source. Nodes less than `least_gap` apart are summed pair by pair: the
  /// kernel is no point's there. `store(target, numbers)` takes the results.
  template <class Store>
  void evaluate(const K& kernel, double least_gap, std::span<const double> targets,
                std::span<const double> sources, std::span<const double> strengths, Store store) {
    source_tree_.build(sources, leaf_capacity_);
    if (!targets.empty()) target_tree_.build(targets, leaf_capacity_);
    targets_ = targets.empty() ? &source_tree_ : &target_tree_;
    take(strengths);
    for (auto& column : sums_)
      column.assign(static_cast<std::size_t>(targets_->count()) + column_padding, 0);
    kernel_ = &kernel;
    least_gap_ = least_gap;
    MultipoleSum<K::dimension, TreeSum>(*targets_, source_tree_, *this, series_).evaluate();
    give(store);
  }

  /// For MultipoleSum.
  const auto& expansion() const { return far_.expansion(); }
  double least_gap() const { return least_gap_; }
  void add_points(Index leaf, double* series) const {
    expansion().add_points(source_tree_, leaf, strengths_, series);
  }
  void add_far(Index leaf, const double* taylor);
  void add_near(Index leaf, std::span<const PointRange> ranges);

 private:
  void take(std::span<const double> strengths);
  template <class Store>
  void give(Store store) const;
  std::array<Lanes, K::dimension> places(const TreeNode<K::dimension>& node, std::size_t i) const;

  Far far_;
  Index leaf_capacity_;
  const K* kernel_ = nullptr;
  double least_gap_ = 0;
  PointTree<K::dimension> source_tree_, target_tree_;
  const PointTree<K::dimension>* targets_ = nullptr;
  Columns<K::strengths> strengths_;  ///< in the order of the source tree
  Columns<K::outputs> sums_;         ///< in the order of the target tree
  std::vector<double> series_;
};

template <PairKernel K, FarField<K> Far>
void TreeSum<K, Far>::take(std::span<const double> strengths) {
  const std::span<const Index> order = source_tree_.order();
  for (auto& column : strengths_) column.resize(order.size() + column_padding);
#pragma omp parallel for schedule(static) if (source_tree_.count() >= parallel_from)
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t s = 0; s < K::strengths; ++s)
      strengths_[s][i] = strengths[K::strengths * static_cast<std::size_t>(order[i]) + s];
}

template <PairKernel K, FarField<K> Far>
template <class Store>
void TreeSum<K, Far>::give(Store store) const {
  const std::span<const Index> order = targets_->order();
#pragma omp parallel for schedule(static) if (targets_->count() >= parallel_from)
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::array<double, K::outputs> numbers;
    for (std::size_t c = 0; c < K::outputs; ++c) numbers[c] = sums_[c][i];
    store(static_cast<std::size_t>(order[i]), numbers);
  }
}

template <PairKernel K, FarField<K> Far>
std::array<Lanes, K::dimension> TreeSum<K, Far>::places(const TreeNode<K::dimension>& node,
                                                        std::size_t i) const {
  const double scale = 1 / node.radius;
  std::array<Lanes, K::dimension> place;
  for (std::size_t d = 0; d < K::dimension; ++d)
    place[d] = (load(&targets_->positions()[d][i]) - node.centre[d]) * scale;
  return place;
}

template <PairKernel K, FarField<K> Far>
void TreeSum<K, Far>::add_far(Index leaf, const double* taylor) {
  const TreeNode<K::dimension>& node = targets_->node(leaf);
  const auto end = static_cast<std::size_t>(node.points.end);
  for (auto i = static_cast<std::size_t>(node.points.begin); i < end; i += lane_count) {
    std::array<Lanes, K::outputs> sums;
    sums.fill(0);
    far_.add(taylor, node.radius, places(node, i), sums);
    for (std::size_t c = 0; c < K::outputs; ++c)
      for (std::size_t k = 0; k < std::min(lane_count, end - i); ++k) sums_[c][i + k] += sums[c][k];
  }
}

template <PairKernel K, FarField<K> Far>
void TreeSum<K, Far>::add_near(Index leaf, std::span<const PointRange> ranges) {
  const auto column_starts = []<class Number, std::size_t N>(auto& columns,
                                                             std::array<Number*, N>& starts) {
    for (std::size_t c = 0; c < N; ++c) starts[c] = columns[c].data();
    return starts;
  };
  SourceColumns<K> sources;
  TargetColumns<K> targets;
  OutputColumns<K> outputs;
  column_starts(source_tree_.positions(), sources.position);
  column_starts(strengths_, sources.strength);
  column_starts(targets_->positions(), targets);
  column_starts(sums_, outputs);
  const auto range = [](PointRange points) {
    return Range{static_cast<std::size_t>(points.begin), static_cast<std::size_t>(points.end)};
  };
  for (const PointRange& points : ranges)
    add_pairs(*kernel_, targets, range(targets_->node(leaf).points), sources, range(points),
              outputs);
}

}  // namespace mote
