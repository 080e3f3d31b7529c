#include "mote/models/tracers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>

#include "mote/geometry/wall_places.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {
namespace {

/// What `left_at` says of a tracer that is under way.
constexpr double under_way = -1;

std::string start_of(const TracerInvariant& invariant) { return invariant.name + "_at_start"; }

}  // namespace

template <int D>
Tracers<D>::Tracers(const TracersOptions& options, SpaceSetup setup)
    : options_(options),
      start_(std::move(setup)),
      velocity_formulas_(options.velocity, start_, "velocity"),
      cloud_(D, static_cast<Index>(start_.position.size() / D)) {
  if (!start_.wall_places.empty())
    throw InputError("model", "tracers know no walls: the velocity says where they go");
  cloud_.add("velocity", FieldKind::vector, "m/s");
  cloud_.add("left_at", FieldKind::scalar, "s");
  cloud_.add("body", FieldKind::scalar, "");
  for (const TracerInvariant& invariant : options_.invariants) {
    cloud_.add(start_of(invariant), FieldKind::scalar, "");
    invariants_.push_back(start_.compile(invariant.formula));
  }
  bind();
  std::ranges::copy(start_.position, position_.begin());
  std::ranges::copy(start_.body, cloud_.values("body").begin());
  std::ranges::fill(left_at_, under_way);
  note_invariants();
  if (options_.method == TracerMethod::streamlines)
    mesh_ = std::make_unique<TracerMesh<D>>(options_, start_, velocity_formulas_);
  start_afresh();
  update_dependent_fields();
  refuse_velocities_without_value<D>(position_, velocity_);
}

template <int D>
void Tracers<D>::bind() {
  position_ = cloud_.position();
  velocity_ = cloud_.values("velocity");
  left_at_ = cloud_.values("left_at");
  if (options_.method == TracerMethod::rates) drifted_ = {{position_, velocity_}};
  crossings_.assign(left_at_.size(), 0);
}

template <int D>
Triple Tracers<D>::place_of(Index i) const {
  Triple place{};
  Vec<D>::Map(place.data()) = position(i);
  return place;
}

template <int D>
double Tracers<D>::invariant(std::size_t number, Index i) const {
  return invariants_[number](place_of(i), 0);
}

template <int D>
void Tracers<D>::note_invariants() {
  for (std::size_t k = 0; k < invariants_.size(); ++k) {
    const auto at_start = cloud_.values(start_of(options_.invariants[k]));
    for (Index i = 0; i < cloud_.count(); ++i) {
      const double value = at_start[static_cast<std::size_t>(i)] = invariant(k, i);
      if (!std::isfinite(value))
        throw InputError(
            fmt::format("model.invariants.{}.formula", k),
            fmt::format("the invariant '{}' has no value for the tracer that starts at {}",
                        options_.invariants[k].name, place_in_words(place_of(i), D)));
    }
  }
}

/// Whether the velocities at these places are the same at three times that have nothing in common.
template <int D>
bool Tracers<D>::is_steady() const {
  const auto velocity_at = [&](double time) {
    std::vector<double> velocity(position_.size());
    velocity_formulas_.add(position_, time, velocity);
    return velocity;
  };
  return velocity_at(0) == velocity_at(0.618) && velocity_at(0) == velocity_at(14.14);
}

template <int D>
Parameters Tracers<D>::parameters() const {
  return {{"tracers", 1}, {"steady", is_steady() ? 1 : 0}};
}

template <int D>
void Tracers<D>::update_drift_rates(double time) {
  time_ = time;
  std::ranges::fill(velocity_, 0);
  velocity_formulas_.add(position_, time, velocity_);
}

/// A step along streamlines; for an integrator only what the box asks for.
template <int D>
void Tracers<D>::end_step(double time, double step) {
  time_ = time + step;
  if (!mesh_) return bring_back_into_the_box();
  mesh_->take_velocities(time + step / 2);
  courant_number_ = mesh_->courant_number(step);
  std::vector<std::exception_ptr> failures(left_at_.size());
#pragma omp parallel for schedule(dynamic, 64) if (cloud_.count() >= parallel_from)
  for (Index i = 0; i < cloud_.count(); ++i) try {
      follow(i, time, step);
    } catch (...) {
      failures[static_cast<std::size_t>(i)] = std::current_exception();
    }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

template <int D>
void Tracers<D>::follow(Index i, double time, double step) {
  const auto number = static_cast<std::size_t>(i);
  crossings_[number] = 0;
  if (left_at_[number] != under_way) return;
  const Passage<D> end = mesh_->follow(position(i), cells_[number], step);
  position(i) = end.position;
  cells_[number] = end.cell;
  crossings_[number] = end.crossings;
  if (end.left) left_at_[number] = time + end.time.value();
}

template <int D>
void Tracers<D>::bring_back_into_the_box() {
  for (std::size_t k = 0; k < position_.size(); ++k) {
    const std::size_t axis = k % D;
    if (!start_.periodic[axis]) continue;
    const double length = start_.upper[axis] - start_.lower[axis];
    position_[k] -= length * std::floor((position_[k] - start_.lower[axis]) / length);
  }
}

template <int D>
void Tracers<D>::update_dependent_fields() {
  update_drift_rates(time_);
}

/// Cells are found from places alone, as a restart has to, each from that of the tracer before it.
template <int D>
void Tracers<D>::start_afresh() {
  if (!mesh_) return;
  cells_.resize(left_at_.size());
  Index last = 0;
  for (Index i = 0; i < cloud_.count(); ++i)
    if (left_at_[static_cast<std::size_t>(i)] == under_way)
      cells_[static_cast<std::size_t>(i)] = last = mesh_->locate(position(i), last);
}

template <int D>
void Tracers<D>::restore(const Cloud& state) {
  Model::restore(state);
  start_afresh();
}

template <int D>
void Tracers<D>::inspect() const {
  for (Index i = 0; i < cloud_.count(); ++i)
    for (const auto& [what, values] : {std::pair("place", position_), {"velocity", velocity_}})
      if (!Vec<D>::Map(values.data() + std::ptrdiff_t{i} * D).allFinite())
        throw NumericalFailure(
            fmt::format("tracer {} has a {} that is not finite", i, what), {i},
            "the step is too long for the integrator, or a formula has no value");
}

template <int D>
Index Tracers<D>::left() const {
  return static_cast<Index>(
      std::ranges::count_if(left_at_, [](double at) { return at != under_way; }));
}

/// Of an invariant 1 less the largest change that a tracer has seen, over the largest value that
/// one has or had at the start.
template <int D>
double Tracers<D>::kept(std::size_t number) const {
  const std::string& name = options_.invariants[number].name;
  const auto at_start = cloud_.values(start_of(options_.invariants[number]));
  double change = 0, scale = 0;
  for (Index i = 0; i < cloud_.count(); ++i) {
    const double start = at_start[static_cast<std::size_t>(i)], now = invariant(number, i);
    if (!std::isfinite(now))
      throw NumericalFailure(
          fmt::format("the invariant '{}' of tracer {} is not a finite number", name, i), {i},
          "its formula has no value where the tracer came to");
    change = std::max(change, std::abs(now - start));
    scale = std::max({scale, std::abs(start), std::abs(now)});
  }
  return change == 0 ? 1 : 1 - change / scale;
}

template <int D>
std::vector<Reading> Tracers<D>::readings() const {
  std::vector<Reading> readings;
  if (mesh_) {
    const auto crossings = std::accumulate(crossings_.begin(), crossings_.end(), std::int64_t{0});
    const auto count = static_cast<double>(cloud_.count());
    readings = {{"crossings", static_cast<double>(crossings) / count},
                {"courant_number", courant_number_},
                {"share_inside", 1 - left() / count}};
  }
  for (std::size_t k = 0; k < invariants_.size(); ++k)
    readings.push_back({options_.invariants[k].name + "_kept", kept(k)});
  return readings;
}

/// A Courant number is one of the mesh, or of the spacing of the tracers where there is no mesh.
template <int D>
double Tracers<D>::longest_step(double time, double courant) {
  if (mesh_) {
    mesh_->take_velocities(time);
    return courant / mesh_->courant_number(1);
  }
  update_drift_rates(time);
  double fastest = 0;
  for (std::size_t k = 0; k < velocity_.size(); k += D)
    fastest = std::max(fastest, Vec<D>::Map(&velocity_[k]).norm());
  return courant * start_.spacing / fastest;
}

template <int D>
std::vector<std::string> Tracers<D>::remarks() const {
  if (!mesh_) return {};
  return {fmt::format("The last step was {:.3g} times the Courant limit of the mesh.",
                      courant_number_)};
}

template <int D>
std::vector<std::string> Tracers<D>::warnings() const {
  if (left() == 0) return {};
  return {
      fmt::format("{} of {} tracers left the domain and stay where they did; 'left_at' says when",
                  left(), cloud_.count())};
}

template class Tracers<2>;
template class Tracers<3>;

}  // namespace mote
