#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "mote/neighbours/lists.hpp"

namespace mote {

/// Neighbours of receiver i with numbers above its own, of a list in the order of numbers: every
/// pair is met from one of its ends.
inline std::span<const Index> later_neighbours(const NeighbourLists& lists, Index i) {
  const auto list = lists[i];
  if (list.empty() || list.front() > i) return list;
  return list.subspan(static_cast<std::size_t>(std::ranges::upper_bound(list, i) - list.begin()));
}

/// An order in which threads meet every pair of neighbours once and add to both its ends without
/// waiting for each other: receivers in blocks of consecutive numbers, and a colour for each block
/// so that no two of a colour reach the same receiver. Colours come one after the other. So what is
/// added to a receiver, and in which order, depends on the lists alone, not on the threads.
class PairOrder {
 public:
  /// Chooses blocks and their colours for lists in the order of numbers.
  void arrange(const NeighbourLists& lists);

  std::size_t blocks() const { return colour_.size(); }
  Index block_size() const { return Index{1} << shift_; }
  std::span<const Index> colours() const { return colour_; }

  /// Calls visit(block, begin, end) with the receivers of every block.
  template <class Visit>
  void for_each_block(Visit visit) const;

 private:
  Index first_of(Index block) const { return std::min(receivers_, block << shift_); }
  void find_reached_blocks(const NeighbourLists& lists);
  void choose_colours();
  void sort_by_colour();

  Index receivers_ = 0;
  int shift_ = 0;                            ///< a block has 2^shift receivers
  std::vector<Index> colour_;                ///< of each block
  std::vector<Index> sorted_, group_start_;  ///< blocks by colour, and where each colour starts
  std::vector<std::vector<Index>> reached_;  ///< blocks that a block reaches, its own too
  std::vector<std::uint64_t> taken_;         ///< one bit a colour that reaches a block
};

template <class Visit>
void PairOrder::for_each_block(Visit visit) const {
#pragma omp parallel if (parallel_from <= receivers_)
  for (std::size_t group = 0; group + 1 < group_start_.size(); ++group) {
#pragma omp for schedule(dynamic, 1)
    for (Index k = group_start_[group]; k < group_start_[group + 1]; ++k) {
      const Index block = sorted_[static_cast<std::size_t>(k)];
      visit(block, first_of(block), first_of(block + 1));
    }
  }
}

}  // namespace mote
