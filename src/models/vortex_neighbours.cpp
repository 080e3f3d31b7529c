#include "mote/models/vortex_neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "mote/particles/failure.hpp"

namespace mote {

template <int D>
VortexNeighbours<D>::VortexNeighbours(const SpaceStart& start, const std::string& search,
                                      const NeighbourRule& rule)
    : rule_(rule), search_(make_search<D>(search.empty() ? "cell_grid" : search)) {
  for (std::size_t d = 0; d < D; ++d) {
    const double width = start.upper[d] - start.lower[d];
    if (start.periodic[d] && width * rim_tolerance < 2 * rule.reach() * start.spacing)
      throw InputError("domain.periodic",
                       fmt::format("the domain is {:.6g} wide along {}, and a periodic one must be "
                                   "twice as wide as diffusion reaches, {:.6g}",
                                   width, axis_names[d], rule.reach() * start.spacing));
  }
}

template <int D>
void VortexNeighbours<D>::find(const VortexParticles<D>& vortices) {
  const Index count = vortices.count();
  points_.position.assign(vortices.position().begin(), vortices.position().end());
  owners_.resize(static_cast<std::size_t>(count));
  std::iota(owners_.begin(), owners_.end(), 0);
  if (vortices.in_a_box()) add_images(vortices.start());
  points_.resize(static_cast<Index>(owners_.size()), count);
  if (D == 2) {
    points_.circulation.resize(owners_.size());
    points_.vorticity.resize(owners_.size());
  }
  std::ranges::fill(points_.length, vortices.start().spacing);
  std::ranges::fill(points_.density, 1);
  for (std::size_t k = 0; k < owners_.size(); ++k)
    points_.mass[k] = vortices.volume()[static_cast<std::size_t>(owners_[k])];
  search_->find(points_, rule_, lists_);
}

/// Along one axis after the other, so that the corners are filled. Vortices may be a part of a step
/// beyond the box, where they have images all the same.
template <int D>
void VortexNeighbours<D>::add_images(const SpaceStart& start) {
  const double reach = 1.5 * rule_.reach() * start.spacing;
  for (std::size_t d = 0; d < D; ++d) {
    const double lower = start.lower[d], upper = start.upper[d];
    const auto copy = [&](std::size_t k, double shift) {
      owners_.push_back(owners_[k]);
      for (std::size_t c = 0; c < D; ++c)
        points_.position.push_back(points_.position[k * D + c] + (c == d ? shift : 0));
    };
    for (std::size_t k = 0, before = owners_.size(); k < before; ++k) {
      const double x = points_.position[k * D + d];
      if (x < lower + reach) copy(k, upper - lower);
      if (x > upper - reach) copy(k, lower - upper);
    }
  }
}

template class VortexNeighbours<2>;
template class VortexNeighbours<3>;

}  // namespace mote
