#pragma once

#include <memory>
#include <string_view>

#include "mote/neighbours/neighbours.hpp"
#include "mote/options/description.hpp"

namespace mote {

/// Finds the neighbours of points in D dimensions. All searches find the same neighbours; they
/// differ in the order of a list, in speed, and in the rules that they know.
template <int D>
class NeighbourSearch {
 public:
  virtual ~NeighbourSearch() = default;

  /// Writes one list for every receiver. Throws std::invalid_argument for a rule that it does not
  /// know.
  virtual void find(const Points<D>& points, const NeighbourRule& rule, NeighbourLists& lists) = 0;
};

/// The names of the searches in D dimensions.
template <int D>
Choices search_names();

/// The search of this name. Throws std::invalid_argument if there is none in D dimensions.
template <int D>
std::unique_ptr<NeighbourSearch<D>> make_search(std::string_view name);

}  // namespace mote
