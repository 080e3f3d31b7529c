#include "mote/models/tracer_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/geometry/wall_places.hpp"
#include "mote/particles/failure.hpp"
#include "mote/xivas/box_points.hpp"

namespace mote {
namespace {

template <int D>
std::vector<double> points_of(const TracersOptions& options, const SpaceStart& start) {
  return points_in_box<D>(Vec<D>::Map(start.lower.data()), Vec<D>::Map(start.upper.data()),
                          {.spacing = options.mesh.spacing.value_or(start.spacing),
                           .jitter = options.mesh.jitter,
                           .seed = static_cast<std::uint64_t>(options.mesh.seed)});
}

template <int D>
std::vector<double> places_of(const SimplexMesh<D>& mesh) {
  std::vector<double> places;
  for (Index i = 0; i < mesh.point_count(); ++i) {
    const Vec<D> place = mesh.point(i);
    places.insert(places.end(), place.data(), place.data() + D);
  }
  return places;
}

template <int D>
std::vector<double> without_upper_sides(std::vector<double> places, const SpaceStart& start) {
  for (std::size_t k = 0; k < places.size(); ++k)
    if (start.periodic[k % D] && places[k] == start.upper[k % D]) places[k] = start.lower[k % D];
  return places;
}

}  // namespace

template <int D>
std::optional<std::string> first_without_value(std::span<const double> places,
                                               std::span<const double> velocity) {
  const auto bad = std::ranges::find_if(velocity, [](double v) { return !std::isfinite(v); });
  if (bad == velocity.end()) return std::nullopt;
  const auto first = (bad - velocity.begin()) / D * D;
  Triple place{};
  std::copy_n(places.begin() + first, D, place.begin());
  return place_in_words(place, D);
}

template <int D>
void refuse_velocities_without_value(std::span<const double> places,
                                     std::span<const double> velocity) {
  if (const auto place = first_without_value<D>(places, velocity))
    throw InputError("model.velocity",
                     fmt::format("the velocity has no value at {} at the start", *place));
}

template <int D>
TracerMesh<D>::TracerMesh(const TracersOptions& options, const SpaceStart& start,
                          const FreeStream<D>& velocity)
    : start_(start),
      velocity_(velocity),
      mesh_(points_of<D>(options, start)),
      places_(without_upper_sides<D>(places_of(mesh_), start)),
      values_(places_.size()),
      streamlines_(NodalField<D>(mesh_, values_)) {
  velocity_.add(places_, 0, values_);
  refuse_velocities_without_value<D>(places_, values_);
  refuse_other_velocities_across_sides();
}

template <int D>
void TracerMesh<D>::take_velocities(double time) {
  std::ranges::fill(values_, 0);
  velocity_.add(places_, time, values_);
  const auto place = first_without_value<D>(places_, values_);
  if (place)
    throw NumericalFailure(
        fmt::format("the velocity at the point {} of the mesh is not a finite number", *place), {},
        "its formula has no value there");
}

template <int D>
void TracerMesh<D>::refuse_other_velocities_across_sides() const {
  constexpr double rounding = 1e-9;
  std::vector<double> values(values_.size());
  velocity_.add(places_of(mesh_), 0, values);
  double largest = 0, jump = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    largest = std::max(largest, std::abs(values_[k]));
    jump = std::max(jump, std::abs(values[k] - values_[k]));
  }
  if (jump > rounding * largest)
    throw InputError("model.velocity",
                     fmt::format("the domain is periodic and the velocity is not: opposite sides "
                                 "differ by up to {:.3g}",
                                 jump));
}

template <int D>
Index TracerMesh<D>::locate(const Vec<D>& place, Index from) const {
  const Index cell = mesh_.locate(place, from);
  if (cell == no_cell)
    throw NumericalFailure("a tracer is not in the domain", {},
                           "a state from elsewhere was taken over");
  return cell;
}

/// Puts what left through a periodic side on the opposite one.
template <int D>
bool TracerMesh<D>::comes_in_again(Passage<D>& at) const {
  if (!at.left) return false;
  Eigen::Index axis = 0;
  at.outward.cwiseAbs().maxCoeff(&axis);
  const auto side = static_cast<std::size_t>(axis);
  if (!start_.periodic[side]) return false;
  at.position[axis] += (at.outward[axis] > 0 ? -1 : 1) * (start_.upper[side] - start_.lower[side]);
  at.cell = mesh_.locate(at.position, at.cell);
  if (at.cell == no_cell)
    throw NumericalFailure("what left through a periodic side is not beside the opposite one", {},
                           "cells of the mesh are as thin as rounding");
  at.left = false;
  ++at.crossings;
  return true;
}

template <int D>
Passage<D> TracerMesh<D>::follow(const Vec<D>& from, Index cell, double time) const {
  Passage<D> at = streamlines_.follow(from, cell, time);
  while (comes_in_again(at)) streamlines_.continue_to(time, at);
  return at;
}

template void refuse_velocities_without_value<2>(std::span<const double>, std::span<const double>);
template void refuse_velocities_without_value<3>(std::span<const double>, std::span<const double>);
template class TracerMesh<2>;
template class TracerMesh<3>;

}  // namespace mote
