#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/models/weakly_compressible.hpp"

namespace mote {

/// Puts the particles in their order in space and finds their neighbours anew.
template <int D>
void WeaklyCompressible<D>::rebuild(double time, double travel) {
  neighbours_.wrap(position_);
  remove_what_left(time);
  skin_ = skin_for(travel);
  // By the reach of the search, which would have to sort them once more otherwise.
  rearrange(neighbours_.order(position_, id_, reach_ + skin_));
  find_neighbours();
}

/// How far the rows should reach beyond the kernel: a longer reach lasts for more steps and costs
/// more in each. The best is where both costs grow alike, (skin/reach)^2 = 2 R travel/(D reach),
/// with rows costing about as much as R = 1 pass.
template <int D>
double WeaklyCompressible<D>::skin_for(double travel) const {
  if (start_.skin) return *start_.skin * reach_;
  const double best = std::sqrt(2 * travel / (D * reach_));
  return reach_ * std::clamp(best, 0.02, 0.1);
}

template <int D>
void WeaklyCompressible<D>::find_neighbours() {
  find_neighbours(needs_all_neighbours() ? ListForm::ascending : ListForm::later);
}

template <int D>
void WeaklyCompressible<D>::find_neighbours(ListForm form) {
  neighbours_.find(position_, idle_, reach_ + skin_, form);
  const Index count = cloud_.count();
  lines_.resize(static_cast<std::size_t>(count) + neighbours_.images().size());
  sums_.assign(lines_.size(), {});
  assign_roles();
  if (drags_at_ghosts()) carrying_.resize(lines_.size());
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i)
    std::copy_n(position_.begin() + std::ptrdiff_t{i} * D, D,
                lines_[static_cast<std::size_t>(i)].value.begin() + Line::position);
  moved_ = 0;
  lists_are_current_ = true;
  ++course_.rebuilds;
}

/// Whether there are ghosts that do not slip.
template <int D>
bool WeaklyCompressible<D>::drags_at_ghosts() const {
  return options_.walls == WallForm::extrapolated &&
         std::ranges::any_of(start_.bodies, [](const Body& body) {
           return body.kind == BodyKind::wall && !body.slips;
         });
}

/// Walls into which the fluid is continued are ghosts.
template <int D>
void WeaklyCompressible<D>::assign_roles() {
  const auto ghost = [&](Index i) {
    return is_wall(i) && options_.walls == WallForm::extrapolated;
  };
  const auto& lists = neighbours_.lists();
  const Index count = cloud_.count();
  roles_.assign(lines_.size(), PairRole::plain);
  const auto images = neighbours_.images();
  for (std::size_t k = 0; k < images.size(); ++k)
    if (ghost(images[k].owner)) roles_[static_cast<std::size_t>(count) + k] = PairRole::ghost;
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) {
    const auto meets = [&](Index j) {
      return ghost(j < count ? j : images[static_cast<std::size_t>(j - count)].owner);
    };
    if (ghost(i))
      roles_[static_cast<std::size_t>(i)] = PairRole::ghost;
    else if (std::ranges::any_of(lists[i], meets))
      roles_[static_cast<std::size_t>(i)] = PairRole::beside_ghosts;
  }
}

/// Whether any sum of a step but those over pairs is over all neighbours of a particle of the
/// fluid.
template <int D>
bool WeaklyCompressible<D>::needs_all_neighbours() const {
  return options_.shifting > 0 || uses_operator() ||
         options_.diffusion == DensityDiffusion::antuono ||
         options_.density_form == FluidDensity::summation;
}

template <int D>
void WeaklyCompressible<D>::rearrange(std::span<const Index> order) {
  cloud_.rearrange(order);
  mote::rearrange(acceleration_, D, order, kept_);
  mote::rearrange(density_rate_, 1, order, kept_);
  name_parts();
}

/// Takes fluid out that is further outside the domain than a wall is thick.
template <int D>
void WeaklyCompressible<D>::remove_what_left(double time) {
  const Index count = cloud_.count();
  Index left = 0;
#pragma omp parallel for schedule(static) reduction(+ : left) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) left += !side_left(i).empty();
  if (left == 0) return;
  order_.clear();
  for (Index i = 0; i < count; ++i) {
    const std::string_view side = side_left(i);
    if (side.empty())
      order_.push_back(i);
    else
      removed_.add(id_[i], Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D), side, time);
  }
  rearrange(order_);
}

/// The side of the domain that a particle of the fluid is so far beyond; empty if it is not.
template <int D>
std::string_view WeaklyCompressible<D>::side_left(Index i) const {
  if (is_wall(i)) return "";
  return mote::side_left<D>(Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D), start_, reach_);
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace mote
