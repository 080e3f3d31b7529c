#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mote/sums/far_pairs.hpp"
#include "mote/sums/point_tree.hpp"

namespace mote {

/// A fast multipole method (Greengard & Rokhlin 1987) on adaptive trees: far pairs of nodes are
/// summed by expansions, near leaves pair by pair. Who is far follows from the nodes' balls alone
/// (dual tree traversal, Dehnen 2002), and is found from the side of the targets: each target node
/// has one writer, which goes through its sources in the order of the tree. So results do not
/// depend on the number of threads.
///
/// `Field` is what is summed:
///   expansion()                 the series: size, degree_for, shift_up, translate, shift_down
///   add_points(leaf, series)    a source leaf's series from its points
///   least_gap()                 nodes that are nearer are no far pairs: the reach of blobs' cores
///   add_far(leaf, taylor)       values at a target leaf's points from its Taylor series
///   add_near(leaf, ranges)      values there from source points, pair by pair
template <int D, class Field>
class MultipoleSum {
 public:
  /// `series` is working memory.
  MultipoleSum(const PointTree<D>& targets, const PointTree<D>& sources, Field& field,
               std::vector<double>& series)
      : targets_(targets), sources_(sources), field_(field), series_(series) {}

  void evaluate() {
    if (targets_.count() == 0 || sources_.count() == 0) return;
    series_.assign(sources_.nodes().size() * field_.expansion().size(), 0);
    const bool many = std::max(targets_.count(), sources_.count()) >= points_a_task;
#pragma omp parallel if (many)
#pragma omp single
    {
      gather(0);
      std::vector<double> taylor(field_.expansion().size(), 0);
      const std::vector<Index> root = {0};
      descend(0, root, taylor.data());
    }
  }

 private:
  static constexpr Index points_a_task = 4096;

  double* series_of(Index n) {
    return series_.data() + static_cast<std::size_t>(n) * field_.expansion().size();
  }

  /// The series of all sources below a node.
  void gather(Index n) {
    if (sources_.is_leaf(n)) return field_.add_points(n, series_of(n));
    const bool many = sources_.node(n).points.count() >= points_a_task;
    std::vector<Child<D>> children;
    sources_.for_each_child(n, [&](Index child) {
      children.push_back({sources_.node(child), series_of(child)});
#pragma omp task if (many) firstprivate(child)
      gather(child);
    });
#pragma omp taskwait
    field_.expansion().shift_up(children, sources_.node(n), series_of(n));
  }

  /// Values at all targets below a node, from `candidates`, source nodes too near to its parent,
  /// and from the Taylor series of all others.
  void descend(Index t, std::span<const Index> candidates, double* taylor) {
    std::vector<Index> kept;
    std::vector<FarPair<D>> far;
    std::vector<PointRange> near;
    sort_sources(t, candidates, kept, far, near);
    field_.expansion().translate(far, targets_.node(t).radius, taylor);
    if (!targets_.is_leaf(t)) return descend_below(t, kept, taylor);
    field_.add_far(t, taylor);
    field_.add_near(t, near);
  }

  void descend_below(Index t, const std::vector<Index>& kept, const double* taylor) {
    std::vector<Child<D>> children;
    std::vector<double> below;
    targets_.for_each_child(t,
                            [&](Index) { below.resize(below.size() + field_.expansion().size()); });
    double* place = below.data();
    targets_.for_each_child(t, [&](Index child) {
      children.push_back({targets_.node(child), place});
      place += field_.expansion().size();
    });
    field_.expansion().shift_down(targets_.node(t), taylor, children);
    const bool many = targets_.node(t).points.count() >= points_a_task;
    place = below.data();
    targets_.for_each_child(t, [&](Index child) {
#pragma omp task if (many) shared(kept) firstprivate(child, place)
      descend(child, kept, place);
      place += field_.expansion().size();
    });
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
      const Vec<D> distance = target.centre - source.centre;
      const int degree = degree_for(source.radius, target.radius, distance.norm());
      if (degree <= field_.expansion().degree())
        far.push_back({series_of(s), distance, source.radius, degree});
      else if (at_leaf && sources_.is_leaf(s))
        add_range(source.points, near);
      else if (at_leaf || (!sources_.is_leaf(s) && source.radius > target.radius))
        open_children(s, open);
      else
        kept.push_back(s);
    }
  }

  int degree_for(double source_radius, double target_radius, double distance) const {
    if (distance - source_radius - target_radius <= field_.least_gap())
      return field_.expansion().degree() + 1;
    return field_.expansion().degree_for(source_radius, target_radius, distance);
  }

  void open_children(Index s, std::vector<Index>& open) {
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

  const PointTree<D>& targets_;
  const PointTree<D>& sources_;
  Field& field_;
  std::vector<double>& series_;
};

}  // namespace mote
