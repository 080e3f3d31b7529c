#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mote/models/vortex_particles.hpp"
#include "mote/neighbours/search.hpp"

namespace mote {

/// The vortices and, in a periodic box, their images, as operators see them: mass is volume, and
/// density 1.
template <int D>
class VortexNeighbours {
 public:
  /// `search` is a name, or empty for the fastest. Throws InputError for a box too narrow.
  VortexNeighbours(const SpaceStart& start, const std::string& search, const NeighbourRule& rule);

  /// Finds who is whose neighbour now.
  void find(const VortexParticles<D>& vortices);

  const Points<D>& points() const { return points_; }
  Points<D>& points() { return points_; }
  const NeighbourLists& lists() const { return lists_; }
  /// Who stands behind point k: itself or the owner of an image.
  Index owner(Index k) const { return owners_[static_cast<std::size_t>(k)]; }

 private:
  void add_images(const SpaceStart& start);

  NeighbourRule rule_;
  std::unique_ptr<NeighbourSearch<D>> search_;
  Points<D> points_;
  NeighbourLists lists_;
  std::vector<Index> owners_;
};

extern template class VortexNeighbours<2>;
extern template class VortexNeighbours<3>;

}  // namespace mote
