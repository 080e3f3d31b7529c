#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mote/sums/far_field.hpp"
#include "mote/sums/pair_loop.hpp"
#include "mote/sums/point_tree.hpp"
#include "mote/sums/translation_error.hpp"

namespace mote {

/// The points of a sum of pairs in the order of their trees.
template <PairKernel K>
struct PlacedPairs {
  const PointTree<K::dimension>& target_tree;
  TargetColumns<K> targets;
  SourceColumns<K> sources;
  std::size_t source_count;
  bool at_sources;  ///< the targets are the sources
};

/// What the largest values of a sum are at least: the largest at a few targets, summed over all
/// sources. Where targets are sources, those to which their own leaf does most are taken, as the
/// largest derivatives are found beside the nearest neighbours; else targets of leaves at random.
/// Costs some pairs a point, and does not depend on the number of threads.
template <PairKernel K>
class LargestValues {
 public:
  LargestValues(const K& kernel, const PlacedPairs<K>& pairs) : kernel_(kernel), pairs_(pairs) {
    choose_targets();
    sum_over_sources();
    if (pairs.at_sources) take_own_potential();
  }

  /// By derivatives of the potential; infinite for those that the kernel does not give.
  FarErrors at_least() const {
    FarErrors largest;
    largest.fill(std::numeric_limits<double>::infinity());
    for (const FieldPart& part : parts) {
      double& of_part = largest[static_cast<std::size_t>(part.derivatives)] = 0;
      for (std::size_t i = 0; i < chosen; ++i) of_part = std::max(of_part, size_of(part, i));
    }
    return largest;
  }

 private:
  static constexpr auto parts = FarField<K>::parts;
  static constexpr std::size_t chosen = lane_count * parts.size();
  static constexpr std::size_t sources_a_task = 16384;

  using Sums = std::array<std::array<double, chosen>, K::outputs>;

  struct Candidate {
    double value;
    std::size_t target;
  };
  using Candidates = std::array<Candidate, parts.size()>;  ///< of one leaf

  static double largest_number(const FieldPart& part, const OutputColumns<K>& outputs,
                               std::size_t i) {
    double largest = 0;
    for (int c = part.first; c < part.first + part.count; ++c)
      largest = std::max(largest, std::abs(outputs[static_cast<std::size_t>(c)][i]));
    return largest;
  }

  double size_of(const FieldPart& part, std::size_t i) const {
    double size = 0;
    for (int c = part.first; c < part.first + part.count; ++c)
      size = std::hypot(size, sums_[static_cast<std::size_t>(c)][i]);
    return size;
  }

  static Range range_of(PointRange points) {
    return {static_cast<std::size_t>(points.begin), static_cast<std::size_t>(points.end)};
  }

  /// Those of the largest values, of each part.
  void choose_targets() {
    std::vector<Candidates> candidates = candidates_of_leaves();
    const std::size_t taken = std::min(lane_count, candidates.size());
    for (std::size_t p = 0; p < parts.size(); ++p) {
      std::ranges::partial_sort(candidates, candidates.begin() + static_cast<std::ptrdiff_t>(taken),
                                std::greater{}, [p](const Candidates& of_leaf) {
                                  return std::pair(of_leaf[p].value, of_leaf[p].target);
                                });
      for (std::size_t k = 0; k < lane_count; ++k)
        targets_[p * lane_count + k] = candidates[k % taken][p].target;
    }
  }

  std::vector<Candidates> candidates_of_leaves() const {
    const PointTree<K::dimension>& tree = pairs_.target_tree;
    std::vector<Range> leaves;
    for (Index n = 0; n < static_cast<Index>(tree.nodes().size()); ++n)
      if (tree.is_leaf(n)) leaves.push_back(range_of(tree.node(n).points));
    std::vector<Candidates> candidates(leaves.size());
#pragma omp parallel for schedule(dynamic, 64) if (leaves.size() > 64)
    for (std::size_t k = 0; k < leaves.size(); ++k)
      candidates[k] = pairs_.at_sources ? most_moved_in(leaves[k]) : any_in(leaves[k]);
    return candidates;
  }

  /// The targets to which the other points of a leaf do most.
  Candidates most_moved_in(Range leaf) const {
    const std::size_t count = leaf.end - leaf.begin;
    std::vector<double> numbers(K::outputs * count);
    OutputColumns<K> outputs;
    for (std::size_t c = 0; c < outputs.size(); ++c) outputs[c] = numbers.data() + c * count;
    TargetColumns<K> targets = pairs_.targets;
    for (const double*& column : targets) column += leaf.begin;
    add_pairs(kernel_, targets, {0, count}, pairs_.sources, leaf, outputs);
    Candidates most;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      most[p] = {0, leaf.begin};
      for (std::size_t i = 0; i < count; ++i)
        if (const double largest = largest_number(parts[p], outputs, i); largest > most[p].value)
          most[p] = {largest, leaf.begin + i};
    }
    return most;
  }

  /// The first target, at random among those of other leaves.
  static Candidates any_in(Range leaf) {
    const std::size_t hash = (leaf.begin + 1) * 0x9E3779B97F4A7C15u >> 32;
    Candidates any;
    any.fill({static_cast<double>(hash), leaf.begin});
    return any;
  }

  void sum_over_sources() {
    std::array<std::array<double, chosen + column_padding>, K::dimension> places{};
    TargetColumns<K> targets;
    for (std::size_t d = 0; d < targets.size(); ++d) {
      for (std::size_t i = 0; i < chosen; ++i) places[d][i] = pairs_.targets[d][targets_[i]];
      targets[d] = places[d].data();
    }
    std::vector<Sums> of_tasks((pairs_.source_count + sources_a_task - 1) / sources_a_task, Sums{});
#pragma omp parallel for schedule(dynamic) if (of_tasks.size() > 1)
    for (std::size_t k = 0; k < of_tasks.size(); ++k) {
      OutputColumns<K> outputs;
      for (std::size_t c = 0; c < outputs.size(); ++c) outputs[c] = of_tasks[k][c].data();
      const std::size_t first = k * sources_a_task;
      add_pairs(kernel_, targets, {0, chosen}, pairs_.sources,
                {first, std::min(first + sources_a_task, pairs_.source_count)}, outputs);
    }
    for (const Sums& of_task : of_tasks)
      for (std::size_t c = 0; c < of_task.size(); ++c)
        for (std::size_t i = 0; i < chosen; ++i) sums_[c][i] += of_task[c][i];
  }

  /// The potential at a source is wanted without its own.
  void take_own_potential() {
    const auto at_centre = at_distance(kernel_.shape, 0);
    for (std::size_t i = 0; i < chosen; ++i) {
      std::array<double, K::strengths> strength;
      for (std::size_t s = 0; s < strength.size(); ++s)
        strength[s] = pairs_.sources.strength[s][targets_[i]];
      std::array<Lanes, K::dimension> nowhere;
      std::array<Lanes, K::outputs> own;
      nowhere.fill(0);
      own.fill(0);
      kernel_.add(nowhere, strength, at_centre, own);
      for (const FieldPart& part : parts)
        if (part.derivatives == 0)
          sums_[static_cast<std::size_t>(part.first)][i] -= own[part.first][0];
    }
  }

  const K& kernel_;
  const PlacedPairs<K>& pairs_;
  std::array<std::size_t, chosen> targets_;
  Sums sums_{};
};

}  // namespace mote
