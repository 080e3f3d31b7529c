#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mote/neighbours/lists.hpp"
#include "mote/operators/differential/differential_operator.hpp"

namespace mote {

/// The weights g_ij and l_ij of an operator for all pairs of the first rows of neighbour lists,
/// kept for several sums. [1/length, 1/length^2]
template <int D>
class PairWeights {
 public:
  /// Rows that `leave_out` marks are 0, and so are rows without finite weights, which it then
  /// marks.
  void find(const DifferentialOperator<D>& op, const NeighbourLists& lists, Index rows,
            std::span<std::uint8_t> leave_out);

  std::span<const Vec<D>> gradient(Index i) const { return row<Vec<D>>(gradient_, i); }
  std::span<const double> laplacian(Index i) const { return row<double>(laplacian_, i); }
  /// The same, to be written.
  std::span<double> laplacian(Index i) {
    return std::span(laplacian_).subspan(first(i), first(i + 1) - first(i));
  }
  /// Number of the first pair of row i among all.
  std::size_t first(Index i) const { return first_[static_cast<std::size_t>(i)]; }
  std::size_t pairs() const { return first_.back(); }
  /// How many pairs have a weight that is not 0: lists may reach further than the operator.
  std::int64_t within_support() const { return within_support_; }

 private:
  template <class Weight>
  std::span<const Weight> row(const std::vector<Weight>& all, Index i) const {
    return std::span(all).subspan(first(i), first(i + 1) - first(i));
  }

  std::vector<std::size_t> first_;
  std::vector<Vec<D>> gradient_;
  std::vector<double> laplacian_;
  std::int64_t within_support_ = 0;
};

extern template class PairWeights<2>;
extern template class PairWeights<3>;

}  // namespace mote
