#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "mote/particles/parallel.hpp"

namespace mote {

/// What the list of a receiver holds: all its neighbours in the order of their search, all in the
/// order of numbers, or only those with numbers above its own, in their order; with these the lists
/// of idle receivers hold all.
enum class ListForm { any_order, ascending, later };

/// The neighbours of every receiver, without the receiver itself, each list in a fixed order that
/// depends on the state alone.
///
/// Lists lie in slabs of memory, wherever their writer put them, and slabs are kept from one search
/// to the next: a neighbour takes 4 B, a receiver 16 B.
class NeighbourLists {
 public:
  class Writer;

  NeighbourLists() = default;
  explicit NeighbourLists(const std::vector<std::vector<Index>>& lists);
  NeighbourLists(const NeighbourLists& other);
  NeighbourLists(NeighbourLists&& other) noexcept = default;
  NeighbourLists& operator=(const NeighbourLists& other) { return *this = NeighbourLists(other); }
  NeighbourLists& operator=(NeighbourLists&& other) noexcept = default;

  std::span<const Index> operator[](Index i) const { return list_[i]; }
  Index receivers() const { return static_cast<Index>(list_.size()); }
  std::int64_t pairs() const;

  /// Forgets all lists and makes room for those of so many receivers, none of them longer than
  /// `longest`. Every receiver has an empty list until its writer closes another.
  void restart(Index receivers, std::size_t longest);

  /// Leaves neighbour j of receiver i in its list only where keep(i, j).
  template <class Keep>
  void keep_if(Keep keep);

  /// Puts every list in the order of numbers.
  void sort();

  /// Whether both hold the same neighbours in the same order.
  friend bool operator==(const NeighbourLists& a, const NeighbourLists& b);

 private:
  /// A slab that nobody writes to yet.
  std::span<Index> take_slab();
  /// Sees to it that threads can share a few neighbours more another time, and find slabs enough.
  void keep_spare_slabs(std::size_t threads);

  std::vector<std::span<Index>> list_;  ///< of each receiver
  std::vector<std::unique_ptr<Index[]>> slabs_;
  std::size_t used_ = 0;  ///< slabs that hold lists
  std::size_t slab_size_ = 0;
};

/// Writes lists on behalf of one thread, one list after another. Several writers may write at once,
/// each to receivers of its own.
class NeighbourLists::Writer {
 public:
  explicit Writer(NeighbourLists& lists) : lists_(lists) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer();

  /// Room for the next list, for up to so many neighbours, at most the longest of `restart`.
  Index* room(std::size_t most) {
    if (static_cast<std::size_t>(end_ - next_) < most) next_slab();
    return next_;
  }

  /// Asks for the memory that `close` will write to for receiver i: where receivers come in no
  /// order, waiting for it takes as long as the search.
  void fetch_ahead(Index i) const { __builtin_prefetch(&lists_.list_[i], 1); }

  /// What was written into the room before `end` is the list of receiver i.
  void close(Index i, Index* end) {
    lists_.list_[i] = {next_, end};
    next_ = end;
  }

 private:
  void next_slab();

  NeighbourLists& lists_;
  Index* next_ = nullptr;
  Index* end_ = nullptr;
};

template <class Keep>
void NeighbourLists::keep_if(Keep keep) {
#pragma omp parallel for schedule(static) if (parallel_from <= receivers())
  for (Index i = 0; i < receivers(); ++i) {
    const std::span<Index> list = list_[i];
    const auto dropped = std::ranges::remove_if(list, [&](Index j) { return !keep(i, j); });
    list_[i] = list.first(list.size() - dropped.size());
  }
}

}  // namespace mote
