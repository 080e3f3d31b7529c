#include "mote/neighbours/search.hpp"

#include <stdexcept>
#include <type_traits>

#include "mote/neighbours/cell_grid.hpp"
#include "mote/neighbours/kd_tree.hpp"
#include "mote/neighbours/line.hpp"
#include "mote/options/type_list.hpp"

namespace mote {
namespace {

/// The searches of mote. A new one is its own pair of files and a word here.
template <int D>
using Searches =
    std::conditional_t<D == 1, TypeList<KdTreeSearch<D>, CellGridSearch<D>, LineSearch>,
                       TypeList<KdTreeSearch<D>, CellGridSearch<D>>>;

}  // namespace

template <int D>
Choices search_names() {
  Choices names;
  for_each_type(Searches<D>(), [&]<class Search>() {
    names.push_back({std::string(Search::name), std::string(Search::summary)});
  });
  return names;
}

template <int D>
std::unique_ptr<NeighbourSearch<D>> make_search(std::string_view name) {
  std::unique_ptr<NeighbourSearch<D>> made;
  for_each_type(Searches<D>(), [&]<class Search>() {
    if (name == Search::name) made = std::make_unique<Search>();
  });
  if (made) return made;
  throw std::invalid_argument("no neighbour search in " + std::to_string(D) + "D is called '" +
                              std::string(name) + "'");
}

template Choices search_names<1>();
template Choices search_names<2>();
template Choices search_names<3>();
template std::unique_ptr<NeighbourSearch<1>> make_search(std::string_view);
template std::unique_ptr<NeighbourSearch<2>> make_search(std::string_view);
template std::unique_ptr<NeighbourSearch<3>> make_search(std::string_view);

}  // namespace mote
