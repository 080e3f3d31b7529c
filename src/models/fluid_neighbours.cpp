#include "mote/models/fluid_neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mote/particles/failure.hpp"

namespace mote {

template <int D>
FluidNeighbours<D>::FluidNeighbours(const SpaceStart& start, const std::string& search,
                                    double reach)
    : lower_(Vec<D>::Map(start.lower.data())),
      upper_(Vec<D>::Map(start.upper.data())),
      periodic_(start.periodic),
      search_(search.empty() || search == CellGridSearch<D>::name ? nullptr
                                                                  : make_search<D>(search)) {
  for (int d = 0; d < D; ++d)
    if (periodic_[static_cast<std::size_t>(d)] &&
        (upper_[d] - lower_[d]) * rim_tolerance < 2 * reach)
      throw InputError("domain.periodic",
                       fmt::format("the domain is {:.6g} wide along {}, and a periodic one must be "
                                   "twice as wide as the operator reaches, {:.6g}",
                                   upper_[d] - lower_[d], axis_names[d], reach));
}

template <int D>
void FluidNeighbours<D>::wrap(std::span<double> position) const {
  const auto count = static_cast<Index>(position.size() / D);
  for (int d = 0; d < D; ++d) {
    if (!periodic_[static_cast<std::size_t>(d)]) continue;
    const double width = upper_[d] - lower_[d];
#pragma omp parallel for schedule(static) if (parallel_from <= count)
    for (Index i = 0; i < count; ++i) {
      double& x = position[static_cast<std::size_t>(i) * D + static_cast<std::size_t>(d)];
      if (x < lower_[d]) x += width;
      if (x >= upper_[d]) x -= width;
    }
  }
}

/// Images beyond one side after the other, so that those of the first are copied beyond the next
/// and the corners are filled.
template <int D>
void FluidNeighbours<D>::add_images(std::span<const double> position, double reach) {
  images_.clear();
  if (periodic_ == std::array<bool, 3>{}) return;
  const auto count = static_cast<Index>(position.size() / D);
  const auto consider = [&](Index owner, const Vec<D>& shift, int d) {
    const double x =
        position[static_cast<std::size_t>(owner) * D + static_cast<std::size_t>(d)] + shift[d];
    const double width = upper_[d] - lower_[d];
    if (x < lower_[d] + reach) images_.push_back({owner, shift + width * Vec<D>::Unit(d)});
    if (x >= upper_[d] - reach) images_.push_back({owner, shift - width * Vec<D>::Unit(d)});
  };
  for (int d = 0; d < D; ++d) {
    if (!periodic_[static_cast<std::size_t>(d)]) continue;
    const std::size_t before = images_.size();
    for (Index i = 0; i < count; ++i) consider(i, Vec<D>::Zero(), d);
    for (std::size_t k = 0; k < before; ++k) {
      const PeriodicImage<D> image = images_[k];
      consider(image.owner, image.shift, d);
    }
  }
}

template <int D>
std::span<const Index> FluidNeighbours<D>::order(std::span<const double> position,
                                                 std::span<const double> id, double reach) {
  id_.assign(id.begin(), id.end());
  return grid_.order(position, static_cast<Index>(id.size()), reach, id_);
}

template <int D>
void FluidNeighbours<D>::find(std::span<const double> position, std::span<const std::uint8_t> idle,
                              double reach, ListForm form) {
  add_images(position, reach);
  const auto count = static_cast<Index>(position.size() / D);
  if (images_.empty()) {
    find_among(position, idle, count, reach, form);
    return;
  }
  points_.assign(position.begin(), position.end());
  idle_.assign(idle.begin(), idle.end());
  for (const PeriodicImage<D>& image : images_) {
    const auto owner = static_cast<std::size_t>(image.owner);
    const Vec<D> place = Vec<D>::Map(position.data() + owner * D) + image.shift;
    points_.insert(points_.end(), place.begin(), place.end());
    idle_.push_back(idle[owner]);
  }
  find_among(points_, idle_, count, reach, form);
}

/// The neighbours of the first `count` points.
template <int D>
void FluidNeighbours<D>::find_among(std::span<const double> place,
                                    std::span<const std::uint8_t> idle, Index count, double reach,
                                    ListForm form) {
  if (search_ == nullptr) {
    grid_.find(place, count, reach, idle, form, lists_);
  } else {
    Points<D> points;
    points.resize(static_cast<Index>(idle.size()), count);
    points.position.assign(place.begin(), place.end());
    std::ranges::fill(points.length, reach);
    search_->find(points, {.support = 1}, lists_);
    lists_.keep_if([&](Index i, Index j) {
      if (idle[static_cast<std::size_t>(i)] != 0) return idle[static_cast<std::size_t>(j)] == 0;
      return form == ListForm::ascending || j > i;
    });
    lists_.sort();
  }
  pair_order_.arrange(lists_);
}

template class FluidNeighbours<2>;
template class FluidNeighbours<3>;

}  // namespace mote
