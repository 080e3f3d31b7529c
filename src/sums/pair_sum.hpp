#pragma once

#include <memory>

#include "mote/sums/direct_sum.hpp"
#include "mote/sums/tree_sum.hpp"

namespace mote {

/// Points of a leaf of a tree: fewer make more far pairs, more make more pairs of points.
template <int D>
inline constexpr Index leaf_capacity = D == 2 ? 64 : 48;

/// Sums of pair kernels over all pairs by the method of the settings, direct or multipole.
template <int D>
class PairSum {
 public:
  /// `expansion` makes the series that the multipole method needs.
  template <class Expansion>
  PairSum(SumMethod method, Expansion expansion) {
    if (method == SumMethod::multipole)
      tree_ = std::make_unique<TreeSum<D>>(expansion(), leaf_capacity<D>);
  }

  /// The points of the next sum; `targets` may be the sources' own places. Strengths are multiplied
  /// by `scale`.
  void place(std::span<const double> targets, const Sources<D>& sources, double scale = 1) {
    tree_ ? tree_->place(targets, sources, scale) : direct_.place(targets, sources, scale);
  }
  /// Forms a kernel's outputs at the targets. Nearer than `shape` reaches it is no point's, to
  /// within `tolerance`.
  template <PairKernel K, class Shape>
  void form(const K& kernel, const Shape& shape, double tolerance) {
    tree_ ? tree_->form(kernel, shape.reach(tolerance)) : direct_.form(kernel);
  }
  /// `columns` of the outputs from `first` on, in the order of the targets.
  void give(int first, int columns, std::span<double> rows) const {
    tree_ ? tree_->give(first, columns, rows) : direct_.give(first, columns, rows);
  }

 private:
  DirectSum<D> direct_;
  std::unique_ptr<TreeSum<D>> tree_;
};

}  // namespace mote
