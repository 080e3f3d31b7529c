#include "mote/models/flow_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mote/particles/failure.hpp"

namespace mote {

template <int D>
FlowParticles<D>::FlowParticles(SpaceStart start, const std::string& search,
                                std::optional<double> skin, double reach)
    : start_(std::move(start)),
      skin_option_(skin),
      reach_(reach),
      cloud_(D, static_cast<Index>(start_.body.size())),
      neighbours_(start_, search, reach) {
  cloud_.add("velocity", FieldKind::vector, "m/s");
  cloud_.add("pressure", FieldKind::scalar, "Pa");
  cloud_.add("body", FieldKind::scalar, "");
  cloud_.add("id", FieldKind::scalar, "");
  name_fields();
  fill();
}

template <int D>
void FlowParticles<D>::fill() {
  std::ranges::copy(start_.position, position_.begin());
  for (Index i = 0; i < count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    body_[k] = start_.body[k];
    id_[k] = i;
  }
  name_fields();
  fluids_at_start_ = fluids_;
  for (Index i = 0; i < fluids_; ++i) {
    Triple place{};
    std::copy_n(position(i).data(), D, place.begin());
    pressure(i) = start_.initial("pressure", place);
    for (int d = 0; d < D; ++d)
      velocity(i)[d] = start_.initial(std::string("velocity_") + axis_names[d], place);
  }
  // An assignment would keep their memory.
  std::vector<double>().swap(start_.position);
  std::vector<std::int32_t>().swap(start_.body);
}

/// To be called whenever the number of particles or their order has changed.
template <int D>
void FlowParticles<D>::name_fields() {
  position_ = cloud_.position();
  velocity_ = cloud_.values("velocity");
  pressure_ = cloud_.values("pressure");
  body_ = cloud_.values("body");
  id_ = cloud_.values("id");
  idle_.resize(static_cast<std::size_t>(count()));
  for (Index i = 0; i < count(); ++i)
    idle_[static_cast<std::size_t>(i)] = body_of(i).kind == BodyKind::wall;
  fluids_ = static_cast<Index>(std::ranges::count(idle_, 0));
}

template <int D>
const WallPlace& FlowParticles<D>::place_of(Index i) const {
  return start_
      .wall_places[static_cast<std::size_t>(id(i)) - static_cast<std::size_t>(fluids_at_start_)];
}

template <int D>
void FlowParticles<D>::observe_walls(double time, double half) {
  observe(start_.bodies, time, half, motions_);
}

template <int D>
void FlowParticles<D>::drift(double duration) {
#pragma omp parallel for schedule(static) if (parallel_from <= count())
  for (Index i = 0; i < count(); ++i) {
    if (i >= fluids_) {
      velocity(i).setZero();
      if (body_of(i).travels) velocity(i) = Vec<D>::Map(motion_of(i).velocity.data());
    }
    position(i) += duration * velocity(i);
  }
}

template <int D>
bool FlowParticles<D>::update_neighbours(double time, double travel) {
  if (lists_are_current_) {
    double furthest = 0;
#pragma omp parallel for schedule(static) reduction(max : furthest) if (parallel_from <= count())
    for (Index i = 0; i < count(); ++i) {
      Line& line = lines_[static_cast<std::size_t>(i)];
      furthest = std::max(furthest, (position(i) - line.place()).squaredNorm());
      Vec<D>::Map(line.value.data() + Line::position) = position(i);
    }
    moved_ += std::sqrt(furthest);
    if (moved_ <= skin_ / 2) return false;
  }
  rebuild(time, travel);
  return true;
}

template <int D>
void FlowParticles<D>::rebuild(double time, double travel) {
  neighbours_.wrap(position_);
  remove_what_left(time);
  // As for pair sums: longer reaches last for more steps and cost more in each.
  skin_ = reach_ * skin_option_.value_or(std::clamp(std::sqrt(travel / reach_), 0.02, 0.1));
  if (!numbers_are_current_ || rebuilds_ - numbered_at_ >= most_rebuilds) number_by_place();
  neighbours_.find(position_, idle_, reach_ + skin_, ListForm::ascending);
  lines_.resize(static_cast<std::size_t>(count()) + neighbours_.images().size());
#pragma omp parallel for schedule(static) if (parallel_from <= count())
  for (Index i = 0; i < count(); ++i)
    Vec<D>::Map(lines_[static_cast<std::size_t>(i)].value.data() + Line::position) = position(i);
  moved_ = 0;
  lists_are_current_ = true;
  ++rebuilds_;
}

template <int D>
void FlowParticles<D>::number_by_place() {
  const auto sorted = neighbours_.order(position_, id_, reach_ + skin_);
  order_.clear();
  for (const std::uint8_t idle : {0, 1})
    std::ranges::copy_if(sorted, std::back_inserter(order_),
                         [&](Index i) { return idle_[static_cast<std::size_t>(i)] == idle; });
  cloud_.rearrange(order_);
  name_fields();
  numbered_at_ = rebuilds_;
  numbers_are_current_ = true;
  ++numberings_;
}

template <int D>
void FlowParticles<D>::copy_to_images() {
  const auto images = neighbours_.images();
  const auto all = static_cast<std::size_t>(count());
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(images.size()))
  for (std::size_t k = 0; k < images.size(); ++k) {
    Line& line = lines_[all + k];
    line = lines_[static_cast<std::size_t>(images[k].owner)];
    Vec<D>::Map(line.value.data() + Line::position) += images[k].shift;
  }
}

template <int D>
void FlowParticles<D>::restore(const Cloud& state) {
  for (const Field& field : cloud_.fields())
    if (!state.has(field.name) || state.count() > cloud_.count())
      throw InputError("this snapshot lacks particles or the field " + field.name);
  removed_.resume(cloud_.count() - state.count());
  cloud_ = state;
  name_fields();
  forget_neighbours();
}

/// Takes fluid out that is further outside the domain than a wall is thick.
template <int D>
void FlowParticles<D>::remove_what_left(double time) {
  order_.clear();
  for (Index i = 0; i < count(); ++i) {
    const std::string_view side = i < fluids_ ? side_left<D>(position(i), start_, reach_) : "";
    if (side.empty())
      order_.push_back(i);
    else
      removed_.add(id(i), position(i), side, time);
  }
  if (static_cast<Index>(order_.size()) == count()) return;
  cloud_.rearrange(order_);
  name_fields();
  numbers_are_current_ = false;
}

template class FlowParticles<2>;
template class FlowParticles<3>;

}  // namespace mote
