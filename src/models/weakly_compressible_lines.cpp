#include <algorithm>
#include <cmath>

#include "mote/models/weakly_compressible.hpp"

namespace mote {

/// Writes the fluid's lines, every velocity and density carried on by `ahead` times its rate, and
/// the places of all, and adds how far the particles went since the last time to how far they have
/// gone. Walls that are dynamic are treated like fluid.
template <int D>
void WeaklyCompressible<D>::write_fluid_lines(double ahead) {
  const bool carried = options_.density_form == FluidDensity::continuity;
  const bool extrapolated = options_.walls == WallForm::extrapolated;
  const Index count = cloud_.count();
  double furthest = 0;
#pragma omp parallel for schedule(static) reduction(max : furthest) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) {
    Line& line = lines_[static_cast<std::size_t>(i)];
    double squared = 0;
    for (std::size_t d = 0; d < D; ++d) {
      const std::size_t k = static_cast<std::size_t>(i) * D + d;
      const double moved = position_[k] - line.value[Line::position + d];
      squared += moved * moved;
      line.value[Line::position + d] = position_[k];
      line.value[Line::velocity + d] = velocity_[k] + ahead * acceleration_[k];
    }
    furthest = std::max(furthest, squared);
    if (is_wall(i) && extrapolated) continue;
    if (is_wall(i)) {
      const Triple& velocity = motion_of(i).velocity;
      for (std::size_t d = 0; d < D; ++d) line.value[Line::velocity + d] = velocity[d];
    }
    const double density = density_[i] + (carried ? ahead * density_rate_[i] : 0);
    line.value[Line::volume] = mass_ / density;
    line.value[Line::pressure] = state_.pressure(density);
  }
  moved_ += std::sqrt(furthest);
}

template <int D>
void WeaklyCompressible<D>::write_image_lines() {
  const auto images = neighbours_.images();
  const auto count = static_cast<std::size_t>(cloud_.count());
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(images.size()))
  for (std::size_t k = 0; k < images.size(); ++k) {
    Line line = lines_[static_cast<std::size_t>(images[k].owner)];
    for (std::size_t d = 0; d < D; ++d)
      line.value[Line::position + d] += images[k].shift[static_cast<Eigen::Index>(d)];
    lines_[count + k] = line;
    if (!carrying_.empty())
      carrying_[count + k] = carrying_[static_cast<std::size_t>(images[k].owner)];
  }
}

/// Density of the fluid as the sum of the masses around.
template <int D>
void WeaklyCompressible<D>::sum_densities() {
  const auto& lists = neighbours_.lists();
#pragma omp parallel for schedule(static) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    if (!is_wall(i)) density_[i] = terms_->density(lines_, i, lists[i], smoothing_length_, mass_);
#pragma omp parallel for schedule(static) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i) {
    if (is_wall(i)) continue;
    Line& line = lines_[static_cast<std::size_t>(i)];
    line.value[Line::volume] = mass_ / density_[i];
    line.value[Line::pressure] = state_.pressure(density_[i]);
  }
  write_image_lines();
}

/// How the walls move now; their accelerations by central differences.
template <int D>
void WeaklyCompressible<D>::observe_walls(double time) {
  const double half = 1e-4 * smoothing_length_ / state_.sound_speed;
  observe(start_.bodies, time, half, motions_);
  walls_at_ = time;
}

template <int D>
void WeaklyCompressible<D>::write_wall_lines() {
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    if (is_wall(i)) extrapolate_to(i);
  write_image_lines();
}

/// The line of a wall particle: the fluid as it goes on into the wall.
template <int D>
void WeaklyCompressible<D>::extrapolate_to(Index i) {
  Line& line = lines_[static_cast<std::size_t>(i)];
  if (neighbours_.lists()[i].empty()) {
    line.value[Line::volume] = mass_ / state_.density;
    line.value[Line::pressure] = options_.background_pressure;
    if (!carrying_.empty()) carrying_[static_cast<std::size_t>(i)] = line.speed();
    return;
  }
  const WallPlace& place = place_of(i);
  const WallMotion& motion = motion_of(i);
  const Surface<D> surface{place.depth, 0.5 * start_.spacing, Vec<D>::Map(place.normal.data()),
                           Vec<D>::Map(motion.velocity.data())};
  const FluidSeen<D> seen =
      terms_->seen(lines_, i, neighbours_.lists()[i], smoothing_length_, mass_, surface);
  const Vec<D> pull =
      gravity() + body_force_.at(Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D), walls_at_) -
      Vec<D>::Map(motion.acceleration.data());
  const ContinuedFluid<D> ghost =
      continue_into_wall(seen, surface, body_of(i).slips, pull, options_.background_pressure);
  Vec<D>::Map(line.value.data() + Line::velocity) = ghost.velocity;
  if (!carrying_.empty()) carrying_[static_cast<std::size_t>(i)] = ghost.carrying;
  line.value[Line::pressure] = ghost.pressure;
  line.value[Line::volume] = mass_ / state_.density_at(ghost.pressure);
}

template <int D>
bool WeaklyCompressible<D>::walls_travel() const {
  return std::ranges::any_of(start_.bodies,
                             [](const Body& body) { return body.velocity && body.travels; });
}

/// Gives walls that travel the velocity they are to have now.
template <int D>
void WeaklyCompressible<D>::move_walls(double time) {
  observe_walls(time);
  if (!walls_travel()) return;
  for (Index i = 0; i < cloud_.count(); ++i)
    if (is_wall(i) && body_of(i).travels)
      std::copy_n(motion_of(i).velocity.begin(), D, velocity_.begin() + std::ptrdiff_t{i} * D);
}

/// Makes rates of the sums, with gravity and the body force, sets those of the walls, and notes the
/// fastest and the most accelerated particle.
template <int D>
void WeaklyCompressible<D>::finish_rates(double time, double ahead) {
  const bool forced = body_force_.has_formulas();
  const bool extrapolated = options_.walls == WallForm::extrapolated;
  const Index count = cloud_.count();
  double speed = 0, most = 0;
#pragma omp parallel for schedule(static) reduction(max : speed, most) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    auto acceleration = Vec<D>::Map(acceleration_.data() + std::ptrdiff_t{i} * D);
    double& rate = density_rate_[k];
    rate = (density_[i] + ahead * rate) * sums_[k].value[PairSums::rate];
    if (is_wall(i)) {
      acceleration.setZero();
      if (body_of(i).travels) acceleration = Vec<D>::Map(motion_of(i).acceleration.data());
      if (extrapolated) rate = 0;
    } else {
      acceleration = Vec<D>::Map(sums_[k].value.data()) + gravity();
      if (forced)
        acceleration += body_force_.at(Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D), time);
    }
    sums_[k] = {};
    most = std::max(most, acceleration.squaredNorm());
    speed = std::max(speed, Vec<D>::Map(velocity_.data() + std::ptrdiff_t{i} * D).squaredNorm());
  }
  highest_speed_ = std::sqrt(speed);
  highest_acceleration_ = std::sqrt(most);
  if (highest_speed_ <= course_.fastest) return;
  course_.fastest = highest_speed_;
  course_.fastest_at = time;
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace mote
