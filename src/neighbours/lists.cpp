#include "mote/neighbours/lists.hpp"

#include <omp.h>

#include <numeric>

namespace mote {
namespace {

/// Neighbours in a slab, unless one list may be longer: 256 KiB.
constexpr std::size_t usual_slab_size = std::size_t{1} << 16;

}  // namespace

NeighbourLists::NeighbourLists(const std::vector<std::vector<Index>>& lists) {
  std::size_t longest = 0;
  for (const auto& list : lists) longest = std::max(longest, list.size());
  restart(static_cast<Index>(lists.size()), longest);
  Writer writer(*this);
  for (Index i = 0; i < receivers(); ++i)
    writer.close(i, std::ranges::copy(lists[i], writer.room(lists[i].size())).out);
}

NeighbourLists::NeighbourLists(const NeighbourLists& other) {
  restart(other.receivers(), other.slab_size_);
  Writer writer(*this);
  for (Index i = 0; i < receivers(); ++i)
    writer.close(i, std::ranges::copy(other[i], writer.room(other[i].size())).out);
}

std::int64_t NeighbourLists::pairs() const {
  return std::accumulate(
      list_.begin(), list_.end(), std::int64_t{0},
      [](std::int64_t sum, auto list) { return sum + static_cast<std::int64_t>(list.size()); });
}

void NeighbourLists::restart(Index receivers, std::size_t longest) {
  list_.resize(static_cast<std::size_t>(receivers));
#pragma omp parallel for schedule(static) if (parallel_from <= receivers)
  for (Index i = 0; i < receivers; ++i) list_[i] = {};
  used_ = 0;
  if (longest <= slab_size_) return;
  slabs_.clear();
  slab_size_ = std::max(usual_slab_size, longest + longest / 8);
}

std::span<Index> NeighbourLists::take_slab() {
  if (used_ == slabs_.size()) slabs_.push_back(std::make_unique_for_overwrite<Index[]>(slab_size_));
  return {slabs_[used_++].get(), slab_size_};
}

void NeighbourLists::keep_spare_slabs(std::size_t threads) {
  const std::size_t wanted = used_ + used_ / 16 + threads;
  while (slabs_.size() < wanted)
    slabs_.push_back(std::make_unique_for_overwrite<Index[]>(slab_size_));
}

void NeighbourLists::sort() {
#pragma omp parallel for schedule(static) if (parallel_from <= receivers())
  for (Index i = 0; i < receivers(); ++i) std::ranges::sort(list_[i]);
}

bool operator==(const NeighbourLists& a, const NeighbourLists& b) {
  if (a.receivers() != b.receivers()) return false;
  for (Index i = 0; i < a.receivers(); ++i)
    if (!std::ranges::equal(a[i], b[i])) return false;
  return true;
}

void NeighbourLists::Writer::next_slab() {
  std::span<Index> slab;
#pragma omp critical(mote_neighbour_slabs)
  slab = lists_.take_slab();
  next_ = slab.data();
  end_ = next_ + slab.size();
}

NeighbourLists::Writer::~Writer() {
  if (!next_) return;
#pragma omp critical(mote_neighbour_slabs)
  lists_.keep_spare_slabs(static_cast<std::size_t>(omp_get_num_threads()));
}

}  // namespace mote
