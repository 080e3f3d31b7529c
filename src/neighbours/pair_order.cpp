#include "mote/neighbours/pair_order.hpp"

#include <bit>
#include <numeric>

namespace mote {
namespace {

/// Receivers of a block, as a power of 2: many, since thin blocks reach many times as many points
/// as they have; not too many, since threads share the blocks of a colour.
int block_shift_for(Index receivers) {
  return std::clamp(static_cast<int>(std::bit_width(static_cast<unsigned>(receivers) / 256)), 7,
                    12);
}

/// Colours that blocks share.
constexpr Index shared_colours = 64;

}  // namespace

void PairOrder::arrange(const NeighbourLists& lists) {
  receivers_ = lists.receivers();
  shift_ = block_shift_for(receivers_);
  find_reached_blocks(lists);
  choose_colours();
  sort_by_colour();
}

void PairOrder::find_reached_blocks(const NeighbourLists& lists) {
  const Index blocks = (receivers_ + block_size() - 1) >> shift_;
  reached_.resize(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic, 4) if (parallel_from <= receivers_)
  for (Index block = 0; block < blocks; ++block) {
    auto& found = reached_[static_cast<std::size_t>(block)];
    found.clear();
    found.reserve(64);
    found.push_back(block);
    for (Index i = first_of(block); i < first_of(block + 1); ++i)
      for (const Index j : later_neighbours(lists, i)) {
        if (j >= receivers_) break;
        const Index other = j >> shift_;
        if (other != found.back() && std::ranges::find(found, other) == found.end())
          found.push_back(other);
      }
  }
}

/// Gives every block the first colour that no block before it has that reaches the same receivers,
/// and one of its own where none is left.
void PairOrder::choose_colours() {
  taken_.assign(reached_.size(), 0);
  colour_.clear();
  Index next_of_its_own = shared_colours;
  for (const auto& blocks : reached_) {
    std::uint64_t taken = 0;
    for (const Index b : blocks) taken |= taken_[static_cast<std::size_t>(b)];
    const Index colour = std::countr_one(taken);
    colour_.push_back(colour < shared_colours ? colour : next_of_its_own++);
    for (const Index b : blocks)
      if (colour < shared_colours)
        taken_[static_cast<std::size_t>(b)] |= std::uint64_t{1} << colour;
  }
}

void PairOrder::sort_by_colour() {
  const Index colours = colour_.empty() ? 0 : std::ranges::max(colour_) + 1;
  group_start_.assign(static_cast<std::size_t>(colours) + 1, 0);
  for (const Index colour : colour_) ++group_start_[static_cast<std::size_t>(colour) + 1];
  std::partial_sum(group_start_.begin(), group_start_.end(), group_start_.begin());
  sorted_.resize(colour_.size());
  for (std::size_t block = 0; block < colour_.size(); ++block)
    sorted_[static_cast<std::size_t>(group_start_[static_cast<std::size_t>(colour_[block])]++)] =
        static_cast<Index>(block);
  std::shift_right(group_start_.begin(), group_start_.end(), 1);
  group_start_.front() = 0;
}

}  // namespace mote
