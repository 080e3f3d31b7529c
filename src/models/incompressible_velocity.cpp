#include <algorithm>

#include "mote/models/incompressible.hpp"

namespace mote {

/// The velocity v without pressure, gravity and force: viscosity at the middle of the step, by the
/// midpoint rule, with the pressure of the last step until there.
template <int D>
void Incompressible<D>::predict(double step) {
  const Index fluids = particles_.fluids();
  const double nu = options_.kinematic_viscosity;
  before_.assign(static_cast<std::size_t>(fluids), 0);
  show_velocities();
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    const auto gradients = weights_.gradient(i);
    const auto list = particles_.lists()[i];
    const auto& lines = particles_.lines();
    const Vec<D> own = lines[static_cast<std::size_t>(i)].speed();
    for (std::size_t k = 0; k < list.size(); ++k)
      before_[static_cast<std::size_t>(i)] +=
          gradients[k].dot(lines[static_cast<std::size_t>(list[k])].speed() - own);
  }
  if (nu > 0) {
    show_pressure();
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
    for (Index i = 0; i < fluids; ++i)
      velocity_[static_cast<std::size_t>(i)] =
          particles_.velocity(i) +
          step / 2 *
              (nu * laplacian_of_velocity(i) + pulls_[static_cast<std::size_t>(i)] -
               gradient_of_pressure(i) / options_.density);
    show(velocity_);
  }
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    velocity_[static_cast<std::size_t>(i)] = particles_.velocity(i);
    if (nu > 0) velocity_[static_cast<std::size_t>(i)] += step * nu * laplacian_of_velocity(i);
  }
}

/// Writes velocities of the fluid into the lines, and lets them go on into walls and images.
template <int D>
void Incompressible<D>::show(const Vectors& velocities) {
  auto& lines = particles_.lines();
  const Index fluids = particles_.fluids();
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i)
    Vec<D>::Map(lines[static_cast<std::size_t>(i)].value.data() + Line::velocity) =
        velocities[static_cast<std::size_t>(i)];
  particles_.copy_to_images();
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= particles_.count())
  for (Index i = fluids; i < particles_.count(); ++i) extrapolate_to(i);
  particles_.copy_to_images();
}

/// The same with the velocities that the particles have, which v becomes.
template <int D>
void Incompressible<D>::show_velocities() {
  const Index fluids = particles_.fluids();
  velocity_.resize(static_cast<std::size_t>(fluids));
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i)
    velocity_[static_cast<std::size_t>(i)] = particles_.velocity(i);
  show(velocity_);
}

template <int D>
void Incompressible<D>::show_pressure() {
  auto& lines = particles_.lines();
  const Index fluids = particles_.fluids();
#pragma omp parallel for schedule(static) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i)
    lines[static_cast<std::size_t>(i)].value[Line::pressure] = particles_.pressure(i);
  particles_.copy_to_images();
#pragma omp parallel for schedule(dynamic, 256) if (parallel_from <= particles_.count())
  for (Index i = fluids; i < particles_.count(); ++i) {
    extrapolate_to(i);
    particles_.pressure(i) = lines[static_cast<std::size_t>(i)].value[Line::pressure];
  }
  particles_.copy_to_images();
}

/// The line of a wall particle: the fluid as it goes on into the wall.
template <int D>
void Incompressible<D>::extrapolate_to(Index i) {
  Line& line = particles_.lines()[static_cast<std::size_t>(i)];
  const WallPlace& place = particles_.place_of(i);
  const WallMotion& motion = particles_.motion_of(i);
  const Surface<D> surface{place.depth, 0.5 * spacing(), Vec<D>::Map(place.normal.data()),
                           Vec<D>::Map(motion.velocity.data())};
  const FluidSeen<D> seen =
      terms_->seen(particles_.lines(), i, particles_.lists()[i], smoothing_length_, mass_, surface);
  const Vec<D> pull = pulls_[static_cast<std::size_t>(i)] - Vec<D>::Map(motion.acceleration.data());
  const ContinuedFluid<D> ghost =
      continue_into_wall(seen, surface, particles_.body_of(i).slips, pull, 0.0);
  Vec<D>::Map(line.value.data() + Line::velocity) = ghost.velocity;
  line.value[Line::pressure] = options_.tension ? ghost.pressure : std::max(0.0, ghost.pressure);
}

template <int D>
Vec<D> Incompressible<D>::laplacian_of_velocity(Index i) const {
  const auto& lines = particles_.lines();
  const auto list = particles_.lists()[i];
  const auto weights = weights_.laplacian(i);
  const Vec<D> own = lines[static_cast<std::size_t>(i)].speed();
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t k = 0; k < list.size(); ++k)
    sum += weights[k] * (lines[static_cast<std::size_t>(list[k])].speed() - own);
  return sum;
}

template <int D>
Vec<D> Incompressible<D>::gradient_of_pressure(Index i) const {
  const auto& lines = particles_.lines();
  const auto list = particles_.lists()[i];
  const auto weights = weights_.gradient(i);
  const auto pressure = [&](Index j) {
    return lines[static_cast<std::size_t>(j)].value[Line::pressure];
  };
  double from = pressure(i);
  if (options_.gradient == PressureGradient::symmetric) from = -from;
  if (options_.gradient == PressureGradient::repulsive)
    for (std::size_t k = 0; k < list.size(); ++k)
      if (particles_.is_fluid(list[k]) && !weights[k].isZero(0))
        from = std::min(from, pressure(list[k]));
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t k = 0; k < list.size(); ++k) sum += weights[k] * (pressure(list[k]) - from);
  return trust_[static_cast<std::size_t>(i)] * sum;
}

/// Particles that are too close and approach each other part again, as hard balls would that lose
/// some of their speed; all pairs at once, so that momentum is kept. At walls they do so at half
/// that distance from the surface.
template <int D>
void Incompressible<D>::collide() {
  const Index fluids = particles_.fluids();
  show_velocities();
  std::int64_t collisions = 0;
#pragma omp parallel for schedule(static) reduction(+ : collisions) if (parallel_from <= fluids)
  for (Index i = 0; i < fluids; ++i) {
    Vec<D> push = Vec<D>::Zero();
    for (const Index j : particles_.lists()[i])
      if (particles_.is_fluid(j)) push += 0.5 * bounce(i, j);
    particles_.velocity(i) += push;
    const Vec<D> from_wall = bounce_off_walls(i);
    particles_.velocity(i) += from_wall;
    collisions += !push.isZero(0) + !from_wall.isZero(0);
  }
  course_.collisions += collisions;
}

/// Change of the velocity of particle i relative to particle j, zero if they do not meet.
template <int D>
Vec<D> Incompressible<D>::bounce(Index i, Index j) const {
  const Line& own = particles_.lines()[static_cast<std::size_t>(i)];
  const Line& other = particles_.lines()[static_cast<std::size_t>(j)];
  const Vec<D> apart = own.place() - other.place();
  const double distance = apart.norm();
  if (distance >= options_.collision_distance * spacing() || distance == 0) return Vec<D>::Zero();
  const double approach = -(own.speed() - other.speed()).dot(apart) / distance;
  return (1 + options_.restitution) * std::max(0.0, approach) / distance * apart;
}

/// Change of the velocity of particle i by the walls that it comes too close to.
template <int D>
Vec<D> Incompressible<D>::bounce_off_walls(Index i) const {
  const auto& lines = particles_.lines();
  const double closest = 0.5 * options_.collision_distance * spacing();
  // Straight above a wall's particle, in its own cell of the surface, whatever lies beside its
  // body.
  const double half_a_diagonal = 0.5 * std::sqrt(D - 1.0) * spacing() * rim_tolerance;
  Vec<D> velocity = particles_.velocity(i);
  for (const Index j : particles_.lists()[i]) {
    const Index wall = particles_.owner(j);
    if (wall < particles_.fluids()) continue;
    const Vec<D> apart = particles_.position(i) - lines[static_cast<std::size_t>(j)].place();
    const WallPlace& place = particles_.place_of(wall);
    const Vec<D> normal = Vec<D>::Map(place.normal.data());
    const double height = apart.dot(normal);
    const double aside = (apart - height * normal).norm();
    if (aside > half_a_diagonal || std::abs(height - place.depth) >= closest) continue;
    const Vec<D> met = Vec<D>::Map(particles_.motion_of(wall).velocity.data());
    const double approach = -(velocity - met).dot(normal);
    if (approach > 0) velocity += (1 + options_.restitution) * approach * normal;
  }
  return velocity - particles_.velocity(i);
}

template class Incompressible<2>;
template class Incompressible<3>;

}  // namespace mote
