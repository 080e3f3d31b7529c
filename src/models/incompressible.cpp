#include "mote/models/incompressible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "mote/operators/differential/mps.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

template <class Wanted, class Given>
std::unique_ptr<Wanted> as(std::unique_ptr<Given> given) {
  return std::unique_ptr<Wanted>(dynamic_cast<Wanted*>(given.release()));
}

/// How far the operator, the terms on its kernel and the test for the surface reach.
template <int D>
double reach_of(const SpaceSetup& setup, SurfaceTest test) {
  const auto& terms = dynamic_cast<const FluidTerms<D>&>(*setup.terms);
  const double seen = test == SurfaceTest::cone ? 2 * cone_length : counted_within;
  return setup.spacing * std::max({terms.support() * setup.smoothing_length, seen,
                                   setup.differential_operator->neighbour_rule().reach()});
}

}  // namespace

template <int D>
Incompressible<D>::Incompressible(const IncompressibleOptions& options, SpaceSetup setup)
    : options_(options),
      particles_(setup, setup.search, setup.skin, reach_of<D>(setup, options.surface_test)),
      terms_(as<FluidTerms<D>>(std::move(setup.terms))),
      operator_(as<DifferentialOperator<D>>(std::move(setup.differential_operator))),
      smoothing_length_(setup.smoothing_length * setup.spacing),
      volume_(std::pow(setup.spacing, D)),
      mass_(options.density * volume_),
      body_force_(options.body_force, particles_.start()) {
  refuse_what_does_not_go_together();
  if (options_.free_surface) particles_.cloud().add("surface", FieldKind::scalar, "");
  particles_.cloud().add("relative_density", FieldKind::scalar, "");
  choose_solver();
  find_full_neighbourhood();
}

template <int D>
void Incompressible<D>::choose_solver() {
  if (options_.laplacian == PressureLaplacian::mps) {
    auto mps = std::make_unique<Mps<D>>();
    mps->constants = MpsConstants::lattice;
    mps->smoothing_length = particles_.reach() / spacing();
    pressure_operator_ = std::move(mps);
  }
  const auto& second = pressure_operator_ ? *pressure_operator_ : *operator_;
  solver_ = make_linear_solver(options_.solver,
                               {.symmetric = second.has_symmetric_laplacian(),
                                .singular = !options_.free_surface,
                                .tolerance = options_.tolerance,
                                .most_iterations = static_cast<Index>(options_.most_iterations),
                                .name = "the pressure equation"});
}

template <int D>
void Incompressible<D>::refuse_what_does_not_go_together() const {
  if (options_.tolerance < LinearSolver::least_tolerance)
    throw InputError("model.solver.tolerance",
                     fmt::format("rounding alone leaves residuals of {:.0e}, and 'tolerance' is "
                                 "{:.3g}",
                                 LinearSolver::least_tolerance, options_.tolerance));
  if (!options_.free_surface && !options_.mean_pressure)
    throw InputError("model.free_surface",
                     "without a free surface nothing fixes the level of the pressure: "
                     "'mean_pressure' is needed");
  if (!options_.free_surface && options_.surface_test == SurfaceTest::missing_neighbours)
    throw InputError("model.surface.test",
                     "'missing_neighbours' gives the pressure a level, and without a free surface "
                     "its mean does");
  if (!options_.free_surface && !options_.tension)
    throw InputError("model.tension",
                     "without a free surface the fluid cannot part, and 'tension: false' would "
                     "only change the mean of its pressure");
  if (options_.free_surface && options_.mean_pressure)
    throw InputError("model.mean_pressure",
                     "at a free surface the pressure is 0, so 'mean_pressure' cannot be given");
}

template <int D>
void Incompressible<D>::end_step(double time, double step) {
  const auto start = std::chrono::steady_clock::now();
  const double instant = 1e-4 * step;
  particles_.observe_walls(time, instant);
  particles_.drift(step / 2);
  take_positions(time, step * highest_speed());
  find_pulls(time + step / 2);
  predict(step);
  project(step);
  note_fields();
  if (options_.collision_distance > 0) collide();
  particles_.observe_walls(time + step, instant);
  particles_.drift(step / 2);
  if (options_.shifting > 0) shift_particles(time + step, step);
  ++course_.steps;
  course_.stepping +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Neighbours, densities and the surface, at the places where particles are now.
template <int D>
void Incompressible<D>::find_surroundings(double time, double travel) {
  particles_.update_neighbours(time, travel);
  for (Line& line : particles_.lines()) line.value[Line::volume] = volume_;
  particles_.copy_to_images();
  find_surface();
}

/// All that a step needs to know of the places where particles are now.
template <int D>
void Incompressible<D>::take_positions(double time, double travel) {
  find_surroundings(time, travel);
  if (particles_.fluids() == 0)
    throw NumericalFailure("no fluid is left", {}, "all of it has left the domain");
  if (options_.free_surface && std::ranges::count(at_surface_, 1) == 0)
    throw NumericalFailure("no particle is at a free surface any more", {},
                           "the fluid has filled all of its space, and nothing fixes the level of "
                           "the pressure");
  fill_points();
  find_weights();
  if (pattern_of_ != particles_.rebuilds()) make_pattern();
  work_.pairs += weights_.within_support();
  work_.evaluations += 1;
  work_.mean_neighbours = static_cast<double>(weights_.within_support()) / particles_.fluids();
}

/// What operators see of the lines.
template <int D>
void Incompressible<D>::fill_points() {
  const auto& lines = particles_.lines();
  points_.resize(static_cast<Index>(lines.size()), particles_.fluids());
  points_.exempt.assign(alone_.size(), options_.free_surface);
#pragma omp parallel for schedule(static) if (parallel_from <= points_.size())
  for (Index k = 0; k < points_.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    Vec<D>::Map(points_.position.data() + std::ptrdiff_t{k} * D) = lines[at].place();
    points_.mass[at] = mass_;
    points_.density[at] = options_.density;
    points_.length[at] = spacing();
  }
}

/// A particle without usable weights counts as one at the surface that is alone.
template <int D>
void Incompressible<D>::find_weights() {
  const auto& lists = particles_.lists();
  operator_->prepare(points_, lists);
  weights_.find(*operator_, lists, particles_.fluids(), alone_);
  for (std::size_t i = 0; i < alone_.size(); ++i)
    if (alone_[i] != 0) at_surface_[i] = 1;
  if (options_.free_surface && !operator_->has_symmetric_laplacian()) free_surface_of_stress();
  if (!pressure_operator_) return;
  pressure_operator_->prepare(points_, lists);
  pressure_weights_.resize(weights_.pairs());
#pragma omp parallel for schedule(static) if (parallel_from <= particles_.fluids())
  for (Index i = 0; i < particles_.fluids(); ++i)
    pressure_operator_->laplacian_weights(
        i, std::span(pressure_weights_).subspan(weights_.first(i), lists[i].size()));
}

/// At the surface the pressure is given, and no stress acts from beyond: the Laplacian of Brookshaw
/// (1985), l_ij = 2 g_ij.x_ij/r^2, has the slope 0 across it and positive weights, by which
/// friction always damps. A corrected one continues the curvature of the velocity beyond the
/// surface instead.
template <int D>
void Incompressible<D>::free_surface_of_stress() {
  const auto& lines = particles_.lines();
#pragma omp parallel for schedule(static) if (parallel_from <= particles_.fluids())
  for (Index i = 0; i < particles_.fluids(); ++i) {
    if (at_surface_[static_cast<std::size_t>(i)] == 0) continue;
    const auto list = particles_.lists()[i];
    const auto gradient = weights_.gradient(i);
    const auto laplacian = weights_.laplacian(i);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Vec<D> x = lines[static_cast<std::size_t>(list[k])].place() -
                       lines[static_cast<std::size_t>(i)].place();
      laplacian[k] = 2 * gradient[k].dot(x) / x.squaredNorm();
    }
  }
}

template <int D>
std::span<const double> Incompressible<D>::pressure_laplacian(Index i) const {
  if (!pressure_operator_) return weights_.laplacian(i);
  return std::span(pressure_weights_).subspan(weights_.first(i), particles_.lists()[i].size());
}

template <int D>
double Incompressible<D>::highest_speed() const {
  double most = 0;
#pragma omp parallel for schedule(static) \
    reduction(max                         \
              : most) if (parallel_from <= particles_.count())
  for (Index i = 0; i < particles_.count(); ++i)
    most = std::max(most, particles_.velocity(i).squaredNorm());
  return std::sqrt(most);
}

/// Of walls with a velocity, and of what they gain while they cross a spacing.
template <int D>
double Incompressible<D>::highest_wall_speed(double time) const {
  double most = 0;
  for (const Body& body : bodies()) {
    if (!body.velocity) continue;
    const auto at = [&](double moment) -> Vec<D> {
      return Vec<D>::Map(body.velocity(moment).data());
    };
    const double instant = 1e-6 * std::max(1.0, std::abs(time));
    const double gain = (at(time + instant) - at(time)).norm() / instant;
    most = std::max(most, at(time).norm() + std::sqrt(gain * spacing()));
  }
  return most;
}

/// Gradients that are not 0 for a constant pressure push particles back to where they lie
/// regularly, which swings with the speed sqrt(p/rho).
template <int D>
double Incompressible<D>::longest_step(double time, double courant) {
  find_pulls(time);
  double pull = 0;
  for (const Vec<D>& each : pulls_) pull = std::max(pull, each.norm());
  const double dx = spacing(), speed = std::max(highest_speed(), highest_wall_speed(time));
  double step = std::numeric_limits<double>::infinity();
  if (speed > 0) step = courant * dx / speed;
  double highest = 0;
  for (const double pressure : cloud().values("pressure")) highest = std::max(highest, pressure);
  if (options_.gradient != PressureGradient::plain && highest > 0)
    step = std::min(step, courant * dx / std::sqrt(highest / options_.density));
  if (pull > 0) step = std::min(step, courant * std::sqrt(dx / pull));
  if (options_.kinematic_viscosity > 0)
    step = std::min(step,
                    0.125 * smoothing_length_ * smoothing_length_ / options_.kinematic_viscosity);
  return step;
}

template <int D>
void Incompressible<D>::find_pulls(double time) {
  pulls_.resize(static_cast<std::size_t>(particles_.count()));
#pragma omp parallel for schedule(static) if (parallel_from <= particles_.count())
  for (Index i = 0; i < particles_.count(); ++i)
    pulls_[static_cast<std::size_t>(i)] = gravity() + body_force_.at(particles_.position(i), time);
}

template <int D>
void Incompressible<D>::inspect() const {
  for (Index i = 0; i < particles_.fluids(); ++i)
    if (!particles_.position(i).allFinite() || !particles_.velocity(i).allFinite())
      throw NumericalFailure(
          fmt::format("particle {} has a velocity that is not finite", particles_.id(i)), {i},
          "the step is too long");
}

template class Incompressible<2>;
template class Incompressible<3>;

}  // namespace mote
