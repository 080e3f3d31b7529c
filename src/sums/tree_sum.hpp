#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "mote/sums/far_field.hpp"
#include "mote/sums/lane_access.hpp"
#include "mote/sums/largest_values.hpp"
#include "mote/sums/multipole_sum.hpp"
#include "mote/sums/number_columns.hpp"
#include "mote/sums/pair_loop.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {

/// Sums of pair kernels over all pairs by the fast multipole method; the work arrays stay from call
/// to call.
template <int D>
class TreeSum {
 public:
  TreeSum(FarExpansion<D> expansion, Index leaf_capacity)
      : multipoles_(std::move(expansion)), leaf_capacity_(leaf_capacity) {}

  /// The points of the next sum; `targets` may be the sources' own places. `strengths` are
  /// multiplied by `scale`.
  void place(std::span<const double> targets, const Sources<D>& sources, double scale = 1) {
    source_tree_.build(sources.position, leaf_capacity_);
    const bool same =
        targets.data() == sources.position.data() && targets.size() == sources.position.size();
    if (!same) target_tree_.build(targets, leaf_capacity_);
    targets_ = same ? &source_tree_ : &target_tree_;
    const std::size_t count = sources.position.size() / D;
    columns_ = count == 0 ? 1 : static_cast<int>(sources.strength.size() / count);
    strengths_.take(sources.strength, columns_, scale, source_tree_.order());
  }

  /// Forms a kernel's outputs at the targets. Nodes less than `least_gap` apart are summed pair by
  /// pair: the kernel is no point's there.
  template <PairKernel K>
  void form(const K& kernel, double least_gap) {
    outputs_.clear(static_cast<std::size_t>(targets_->count()), K::outputs);
    std::array<const double*, K::strengths> strengths;
    for (int s = 0; s < K::strengths; ++s)
      strengths[static_cast<std::size_t>(s)] = strengths_.column(s);
    if constexpr (D == 3) expect_largest(kernel, strengths);
    Leaves<K> leaves(kernel, *this, strengths);
    multipoles_.evaluate({*targets_, source_tree_, strengths, least_gap}, leaves);
  }

  /// `columns` of the outputs from `first` on, in the order of the targets.
  void give(int first, int columns, std::span<double> rows) const {
    outputs_.give(first, columns, rows, targets_->order());
  }

 private:
  template <PairKernel K>
  class Leaves;

  /// Tells the expansions how large the sums will be at least, which their tolerance is relative
  /// to.
  template <PairKernel K>
  void expect_largest(const K& kernel, const std::array<const double*, K::strengths>& strengths) {
    if (targets_->count() == 0 || source_tree_.count() == 0) return;
    PlacedPairs<K> pairs{
        *targets_, {}, {{}, strengths}, strengths_.rows(), targets_ == &source_tree_};
    for (std::size_t d = 0; d < D; ++d) {
      pairs.targets[d] = targets_->positions()[d].data();
      pairs.sources.position[d] = source_tree_.positions()[d].data();
    }
    multipoles_.expansion().expect(LargestValues<K>(kernel, pairs).at_least());
  }

  MultipoleSum<D> multipoles_;
  Index leaf_capacity_;
  PointTree<D> source_tree_, target_tree_;
  const PointTree<D>* targets_ = nullptr;
  int columns_ = 1;
  NumberColumns strengths_, outputs_;  ///< in the order of their trees
};

/// The sums of one kernel at the leaves.
template <int D>
template <PairKernel K>
class TreeSum<D>::Leaves final : public LeafSums {
 public:
  Leaves(const K& kernel, TreeSum& sum, const std::array<const double*, K::strengths>& strengths)
      : kernel_(kernel), expansion_(sum.multipoles_.expansion()), tree_(*sum.targets_) {
    for (std::size_t d = 0; d < D; ++d) {
      targets_[d] = tree_.positions()[d].data();
      sources_.position[d] = sum.source_tree_.positions()[d].data();
    }
    sources_.strength = strengths;
    for (std::size_t c = 0; c < K::outputs; ++c)
      outputs_[c] = sum.outputs_.column(static_cast<int>(c));
  }

  void add_far(Index leaf, const double* taylor) override {
    const TreeNode<D>& node = tree_.node(leaf);
    const FarField<K> field(expansion_, taylor, node.radius);
    const Range range = range_of(node.points);
    for (std::size_t i = range.begin; i < range.end; i += lane_count) {
      std::array<Lanes, D> offset;
      for (std::size_t d = 0; d < D; ++d) offset[d] = load(targets_[d] + i) - node.centre[d];
      std::array<Lanes, K::outputs> sums;
      sums.fill(0);
      field.add(offset, sums);
      for (std::size_t c = 0; c < K::outputs; ++c)
        pair_loop::add_to_column(sums[c], outputs_[c] + i, range.end - i);
    }
  }

  void add_near(Index leaf, std::span<const PointRange> sources) override {
    for (const PointRange& points : sources)
      add_pairs(kernel_, targets_, range_of(tree_.node(leaf).points), sources_, range_of(points),
                outputs_);
  }

 private:
  static Range range_of(PointRange points) {
    return {static_cast<std::size_t>(points.begin), static_cast<std::size_t>(points.end)};
  }

  const K& kernel_;
  const FarExpansion<D>& expansion_;
  const PointTree<D>& tree_;
  TargetColumns<K> targets_;
  SourceColumns<K> sources_;
  OutputColumns<K> outputs_;
};

}  // namespace mote
