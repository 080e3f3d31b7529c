#pragma once

#include "mote/sums/number_columns.hpp"
#include "mote/sums/pair_loop.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {

/// Sums over all pairs, pair by pair; the work arrays stay from call to call.
template <int D>
class DirectSum {
 public:
  /// The points of the next sum; strengths are multiplied by `scale`.
  void place(std::span<const double> targets, const Sources<D>& sources, double scale = 1) {
    targets_.take(targets, D);
    sources_.take(sources.position, D);
    const auto count = sources.position.size() / D;
    strengths_.take(sources.strength, count == 0 ? 1 : int(sources.strength.size() / count), scale);
  }

  /// Forms a kernel's outputs at the targets. Each has one writer, and sources come in order.
  template <PairKernel K>
  void form(const K& kernel) {
    outputs_.clear(targets_.rows(), K::outputs);
    TargetColumns<K> targets;
    SourceColumns<K> sources;
    OutputColumns<K> outputs;
    for (int d = 0; d < D; ++d) targets[d] = targets_.column(d);
    for (int d = 0; d < D; ++d) sources.position[d] = sources_.column(d);
    for (int s = 0; s < K::strengths; ++s) sources.strength[s] = strengths_.column(s);
    for (int c = 0; c < K::outputs; ++c) outputs[c] = outputs_.column(c);
    const std::size_t count = targets_.rows(), all = sources_.rows();
    const auto blocks =
        static_cast<std::ptrdiff_t>((count + targets_at_once - 1) / targets_at_once);
#pragma omp parallel for schedule(dynamic) if (blocks > 1)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      const std::size_t first = b * targets_at_once;
      add_pairs<K>(kernel, targets, {first, std::min(first + targets_at_once, count)}, sources,
                   {0, all}, outputs);
    }
  }

  /// `columns` of the outputs from `first` on, in the order of the targets.
  void give(int first, int columns, std::span<double> rows) const {
    outputs_.give(first, columns, rows);
  }

 private:
  static constexpr std::size_t targets_at_once = 384;  // whole groups of 1, 2, 3 or 4 packs

  NumberColumns targets_, sources_, strengths_, outputs_;
};

}  // namespace mote
