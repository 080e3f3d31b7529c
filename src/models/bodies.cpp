#include "mote/models/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

template <int D>
Vec<D> vector_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return Vec<D>::Zero();
  return Vec<D>::Map(numbers.data());
}

template <int D>
MassList<D> all_bodies(const BodiesOptions& options) {
  MassList<D> bodies;
  for (const PointMass& body : options.masses)
    bodies.add(body.mass, vector_of<D>(body.position), vector_of<D>(body.velocity));
  for (const Cluster& cluster : options.clusters)
    bodies.append(sampled<D>(cluster, options.gravitational_constant));
  return bodies;
}

template <int D>
void refuse_two_on_one_place(const BodiesOptions& options, const MassList<D>& bodies) {
  std::vector<std::size_t> order(bodies.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t i) { return std::span(bodies.position).subspan(i * D, D); };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::ranges::lexicographical_compare(place(a), place(b));
  });
  const auto same = std::ranges::adjacent_find(
      order, [&](std::size_t a, std::size_t b) { return std::ranges::equal(place(a), place(b)); });
  if (same == order.end()) return;
  const std::size_t second = *std::next(same);
  throw InputError(
      options.key_of(second),
      fmt::format("{} and {} stand on one place", options.name_of(*same), options.name_of(second)));
}

std::vector<std::optional<double>> radii_of(const BodiesOptions& options) {
  std::vector<std::optional<double>> radii;
  for (const PointMass& body : options.masses) radii.push_back(body.radius);
  return radii;
}

void refuse_a_box(const SpaceStart& start) {
  for (std::size_t d = 0; d < start.periodic.size(); ++d)
    if (start.periodic[d])
      throw InputError("domain.periodic",
                       "bodies move in unbounded space, so no axis can be periodic");
}

}  // namespace

template <int D>
Bodies<D>::Bodies(const BodiesOptions& options, SpaceSetup setup)
    : options_(options),
      start_(std::move(setup)),
      cloud_(D, 0),
      gravity_(std::make_unique<OwnGravity<D>>(
          options.gravitational_constant, SumChoice{options.sum, options.tolerance, options.core})),
      collisions_(radii_of(options)) {
  refuse_a_box(start_);
  start_.bodies = {Body{.name = "bodies"}};
  cloud_.add("velocity", FieldKind::vector, "m/s");
  cloud_.add("acceleration", FieldKind::vector, "m/s²");
  cloud_.add("mass", FieldKind::scalar, "kg");
  cloud_.add("potential", FieldKind::scalar, "m²/s²");
  cloud_.add("body", FieldKind::scalar, "");
  if (collisions_.exist()) cloud_.add("collisions", FieldKind::scalar, "");
  add(options);
  refuse_contact();
  complete_fields();
}

template <int D>
void Bodies<D>::add(const BodiesOptions& options) {
  const MassList<D> bodies = all_bodies<D>(options);
  refuse_two_on_one_place(options, bodies);
  cloud_.resize(static_cast<Index>(bodies.count()));
  bind();
  std::ranges::copy(bodies.position, position_.begin());
  std::ranges::copy(bodies.velocity, velocity_.begin());
  std::ranges::copy(bodies.mass, mass_.begin());
}

template <int D>
void Bodies<D>::bind() {
  position_ = cloud_.position();
  velocity_ = cloud_.values("velocity");
  acceleration_ = cloud_.values("acceleration");
  mass_ = cloud_.values("mass");
  potential_ = cloud_.values("potential");
  if (collisions_.exist()) met_ = cloud_.values("collisions");
  drifted_ = {{position_, velocity_}};
  kicked_ = {{velocity_, acceleration_}};
  if (point_masses())
    series_ = std::make_unique<GravitySeries<D>>(options_.gravitational_constant, mass_);
}

template <int D>
void Bodies<D>::refuse_contact() const {
  const auto pair = collisions_.contact(position_);
  if (!pair) return;
  const auto [first, second] = *pair;
  throw InputError(options_.key_of(second),
                   fmt::format("{} and {} are in contact at the start", options_.name_of(first),
                               options_.name_of(second)));
}

template <int D>
void Bodies<D>::begin_step(double /*time*/, double /*step*/) {
  if (collisions_.exist()) collisions_.begin_step({position_, velocity_});
}

template <int D>
void Bodies<D>::end_step(double time, double step) {
  if (!collisions_.exist()) return;
  for (const Collision& collision : collisions_.end_step(time, step, {position_, velocity_})) {
    for (const std::size_t body : {collision.first, collision.second}) ++met_[body];
    if (first_collisions_.size() < told_collisions) first_collisions_.push_back(collision);
  }
}

template <int D>
std::optional<PointMasses> Bodies<D>::point_masses() const {
  if (options_.core != "point") return std::nullopt;
  return PointMasses{options_.gravitational_constant, mass_};
}

/// Accelerations follow from places alone. They are formed where they are wanted, and not twice for
/// the same places.
template <int D>
void Bodies<D>::form_accelerations() const {
  if (std::ranges::equal(accelerated_at_, position_)) return;
  gravity_->accelerate(sources(), acceleration_);
  are_new_ = true;
  accelerated_at_.assign(position_.begin(), position_.end());
}

/// What reports want of accelerations is not counted: it is not the method's work.
template <int D>
void Bodies<D>::update_kick_rates(double /*time*/) {
  form_accelerations();
  if (std::exchange(are_new_, false)) ++evaluations_;
}

template <int D>
void Bodies<D>::complete_fields() {
  form_accelerations();
  gravity_->find_potential(sources(), potential_);
}

template <int D>
void Bodies<D>::inspect() const {
  for (Index i = 0; i < cloud_.count(); ++i)
    if (!at(position_, i).allFinite() || !at(velocity_, i).allFinite())
      throw NumericalFailure(
          fmt::format("{} has a place or a velocity that is not finite",
                      options_.name_of(static_cast<std::size_t>(i))),
          {i}, "two point masses came too close for the step; softening spreads them");
}

template <int D>
void Bodies<D>::restore(const Cloud& state) {
  Model::restore(state);
  accelerated_at_.clear();
}

/// A part of the time sqrt(l/a) in which a body at the acceleration a goes the length l: that of
/// the softening, or the distance at which the heaviest body makes it so large.
template <int D>
double Bodies<D>::longest_step(double /*time*/, double courant) {
  form_accelerations();
  const double pull = options_.gravitational_constant * std::ranges::max(mass_);
  double longest = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < cloud_.count(); ++i) {
    const double a = at(acceleration_, i).norm();
    const double length = std::max(options_.core_size, std::pow(pull / a, 1.0 / (D - 1)));
    if (a > 0) longest = std::min(longest, courant * std::sqrt(length / a));
  }
  return longest;
}

template class Bodies<2>;
template class Bodies<3>;

}  // namespace mote
