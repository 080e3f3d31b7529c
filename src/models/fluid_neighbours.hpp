#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mote/models/space.hpp"
#include "mote/neighbours/cell_grid.hpp"
#include "mote/neighbours/pair_order.hpp"
#include "mote/neighbours/search.hpp"

namespace mote {

/// Another place at which a particle of a periodic domain is seen.
template <int D>
struct PeriodicImage {
  Index owner;
  Vec<D> shift;
};

/// Who is whose neighbour among the particles of a flow, periodic images included.
template <int D>
class FluidNeighbours {
 public:
  /// Throws InputError for a periodic domain that is narrower than `reach`.
  FluidNeighbours(const SpaceStart& start, const std::string& search, double reach);

  /// Moves what has left a periodic domain on one side back in on the other.
  void wrap(std::span<double> position) const;

  /// The particles in their order in space, those of one cell by their `id`.
  std::span<const Index> order(std::span<const double> position, std::span<const double> id,
                               double reach);

  /// Finds the neighbours within `reach` of all particles, which stand in that order, but for pairs
  /// of idle ones. `form` is that of the lists, ascending or later.
  void find(std::span<const double> position, std::span<const std::uint8_t> idle, double reach,
            ListForm form);

  /// Behind the particles stand their images.
  std::span<const PeriodicImage<D>> images() const { return images_; }
  const NeighbourLists& lists() const { return lists_; }
  const PairOrder& pair_order() const { return pair_order_; }

 private:
  void add_images(std::span<const double> position, double reach);
  void find_among(std::span<const double> place, std::span<const std::uint8_t> idle, Index count,
                  double reach, ListForm form);

  Vec<D> lower_, upper_;
  std::array<bool, 3> periodic_;
  CellGrid<D> grid_;
  std::unique_ptr<NeighbourSearch<D>> search_;  ///< in place of the grid; null if the grid does
  std::vector<PeriodicImage<D>> images_;
  std::vector<double> points_;      ///< places of particles and images, where there are images
  std::vector<std::uint8_t> idle_;  ///< of the same
  std::vector<Index> id_;
  NeighbourLists lists_;
  PairOrder pair_order_;
};

extern template class FluidNeighbours<2>;
extern template class FluidNeighbours<3>;

}  // namespace mote
