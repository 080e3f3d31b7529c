#include "mote/sums/multipole_sum.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mote {
namespace {

/// Nodes of at least so many points are tasks of their own.
constexpr Index points_a_task = 4096;

}  // namespace

template <int D>
void MultipoleSum<D>::evaluate(const TreePair<D>& points, LeafSums& leaves) {
  if (points.targets.count() == 0 || points.sources.count() == 0) return;
  series_.resize(points.sources.nodes().size() * expansion_.size());
  expansion_.make_room_for_threads();
  const bool many = std::max(points.targets.count(), points.sources.count()) >= points_a_task;
#pragma omp parallel if (many)
#pragma omp single
  {
    gather(points, 0);
    std::vector<double> taylor(expansion_.size(), 0);
    const std::vector<Index> root = {0};
    Descent(*this, points, leaves).descend(0, root, taylor.data());
  }
}

/// The series of all sources below a node; cleared here, by the thread that fills it at once.
template <int D>
void MultipoleSum<D>::gather(const TreePair<D>& points, Index n) {
  const PointTree<D>& tree = points.sources;
  std::fill_n(series_of(n), expansion_.size(), 0.0);
  if (tree.is_leaf(n)) return expansion_.add_points(tree, n, points.strengths, series_of(n));
  std::vector<Index> below;
  std::vector<Child<D>> children;
  tree.for_each_child(n, [&](Index child) {
    below.push_back(child);
    children.push_back({tree.node(child), series_of(child)});
  });
  const bool many = tree.node(n).points.count() >= points_a_task;
  for (std::size_t k = 0; k < below.size(); ++k)
#pragma omp task if (many) shared(points, below) firstprivate(k)
    gather(points, below[k]);
#pragma omp taskwait
  expansion_.shift_up(children, tree.node(n), series_of(n));
}

/// The way down the targets' tree.
template <int D>
class MultipoleSum<D>::Descent {
 public:
  Descent(MultipoleSum& sum, const TreePair<D>& points, LeafSums& leaves)
      : sum_(sum),
        expansion_(sum.expansion_),
        targets_(points.targets),
        sources_(points.sources),
        least_gap_(points.least_gap),
        leaves_(leaves) {}

  /// Values at all targets below a node, from `candidates`, source nodes too near to its parent,
  /// and from the Taylor series of all others.
  void descend(Index t, std::span<const Index> candidates, double* taylor) {
    std::vector<Index> kept;
    std::vector<FarPair<D>> far;
    std::vector<PointRange> near;
    sort_sources(t, candidates, kept, far, near);
    expansion_.translate(far, targets_.node(t).radius, taylor);
    if (!targets_.is_leaf(t)) return descend_below(t, kept, taylor);
    leaves_.add_far(t, taylor);
    leaves_.add_near(t, near);
  }

 private:
  void descend_below(Index t, const std::vector<Index>& kept, const double* taylor) {
    std::vector<Index> below;
    targets_.for_each_child(t, [&](Index child) { below.push_back(child); });
    std::vector<double> series(below.size() * expansion_.size(), 0);
    std::vector<Child<D>> children;
    for (std::size_t k = 0; k < below.size(); ++k)
      children.push_back({targets_.node(below[k]), series.data() + k * expansion_.size()});
    expansion_.shift_down(targets_.node(t), taylor, children);
    const bool many = targets_.node(t).points.count() >= points_a_task;
    for (std::size_t k = 0; k < below.size(); ++k)
#pragma omp task if (many) shared(kept, below, children) firstprivate(k)
      descend(below[k], kept, children[k].series);
#pragma omp taskwait
  }

  /// Sorts source nodes into far and near ones, opening those too near for a whole, and keeps for
  /// the target's children those that are not the larger of the two.
  void sort_sources(Index t, std::span<const Index> candidates, std::vector<Index>& kept,
                    std::vector<FarPair<D>>& far, std::vector<PointRange>& near) {
    const TreeNode<D>& target = targets_.node(t);
    const bool at_leaf = targets_.is_leaf(t);
    std::vector<Index> open(candidates.rbegin(), candidates.rend());
    while (!open.empty()) {
      const Index s = open.back();
      open.pop_back();
      const TreeNode<D>& source = sources_.node(s);
      const Vec<D> apart = target.centre - source.centre;
      const int degree = degree_for(sum_.series_of(s), source, target, apart.norm());
      const bool both_leaves = at_leaf && sources_.is_leaf(s);
      if (degree <= expansion_.degree() &&
          !(both_leaves && few_pairs(source.points, target.points, degree)))
        far.push_back({sum_.series_of(s), components(apart), source.radius, degree});
      else if (both_leaves)
        add_range(source.points, near);
      else if (at_leaf || (!sources_.is_leaf(s) && source.radius > target.radius))
        open_children(s, open);
      else
        kept.push_back(s);
    }
  }

  int degree_for(const double* series, const TreeNode<D>& source, const TreeNode<D>& target,
                 double distance) const {
    if (distance - source.radius - target.radius <= least_gap_) return expansion_.degree() + 1;
    return expansion_.degree_for(series, source, target, distance);
  }

  /// Whether two leaves are sooner summed pair by pair than by series.
  static bool few_pairs(PointRange sources, PointRange targets, int degree) {
    return std::int64_t{sources.count()} * targets.count() <
           FarExpansion<D>::pairs_for_a_translation(degree);
  }

  static std::array<double, D> components(const Vec<D>& vector) {
    std::array<double, D> numbers;
    std::copy_n(vector.data(), D, numbers.begin());
    return numbers;
  }

  void open_children(Index s, std::vector<Index>& open) const {
    const auto first = static_cast<std::ptrdiff_t>(open.size());
    sources_.for_each_child(s, [&](Index child) { open.push_back(child); });
    std::reverse(open.begin() + first, open.end());
  }

  static void add_range(PointRange points, std::vector<PointRange>& near) {
    if (!near.empty() && near.back().end == points.begin)
      near.back().end = points.end;
    else
      near.push_back(points);
  }

  MultipoleSum& sum_;
  const FarExpansion<D>& expansion_;
  const PointTree<D>&targets_, &sources_;
  double least_gap_;
  LeafSums& leaves_;
};

template class MultipoleSum<2>;
template class MultipoleSum<3>;

}  // namespace mote
