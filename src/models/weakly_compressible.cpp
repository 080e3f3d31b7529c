#include "mote/models/weakly_compressible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/models/fixed_sum.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

EquationOfState state_of(const WeaklyCompressibleOptions& options) {
  const bool tait = options.equation_of_state == StateEquation::tait;
  return {options.density, options.sound_speed, tait ? options.exponent : 1,
          options.background_pressure};
}

template <class Wanted, class Given>
std::unique_ptr<Wanted> as(std::unique_ptr<Given> given) {
  auto* wanted = dynamic_cast<Wanted*>(given.release());
  return std::unique_ptr<Wanted>(wanted);
}

}  // namespace

template <int D>
WeaklyCompressible<D>::WeaklyCompressible(const WeaklyCompressibleOptions& options,
                                          SpaceSetup setup)
    : options_(options),
      start_(std::move(setup)),
      state_(state_of(options)),
      terms_(as<FluidTerms<D>>(std::move(start_.terms))),
      operator_(as<DifferentialOperator<D>>(std::move(start_.differential_operator))),
      smoothing_length_(start_.smoothing_length * start_.spacing),
      reach_(std::max(terms_->support() * smoothing_length_,
                      operator_->neighbour_rule().reach() * start_.spacing)),
      mass_(options.density * std::pow(start_.spacing, D)),
      body_force_(options.body_force, start_),
      cloud_(D, static_cast<Index>(start_.body.size())),
      neighbours_(start_, start_.search, reach_) {
  refuse_what_does_not_go_together();
  choose_coefficients();
  fill_cloud();
  name_parts();
}

template <int D>
void WeaklyCompressible<D>::refuse_what_does_not_go_together() const {
  const bool has_viscosity =
      options_.viscosity == Viscosity::morris || options_.viscosity == Viscosity::by_operator;
  if (has_viscosity && options_.kinematic_viscosity == 0)
    throw InputError("model.viscosity", "this viscosity needs 'kinematic', and it is 0");
  if (options_.walls == WallForm::dynamic && options_.divergence == Derivatives::by_operator)
    throw InputError("model.divergence",
                     "dynamic walls carry their density in pairs, and need 'divergence: pairs'");
  if (!has_viscosity && options_.kinematic_viscosity > 0)
    throw InputError("model.viscosity",
                     "'kinematic' belongs to the viscosities morris and operator");
}

template <int D>
void WeaklyCompressible<D>::choose_coefficients() {
  const double h = smoothing_length_, c = state_.sound_speed;
  coefficients_.smoothing_length = h;
  coefficients_.mass = mass_;
  coefficients_.continuity = options_.density_form == FluidDensity::continuity &&
                             options_.divergence == Derivatives::pairs;
  coefficients_.pressure = options_.pressure == Derivatives::pairs;
  if (options_.diffusion != DensityDiffusion::none &&
      options_.density_form == FluidDensity::continuity)
    coefficients_.diffusion = options_.diffusion_strength * h * c;
  if (options_.diffusion == DensityDiffusion::fourtakas)
    coefficients_.density_at_rest = state_.density / (c * c) * gravity();
  if (options_.viscosity == Viscosity::artificial)
    coefficients_.artificial_viscosity = options_.alpha * h * c * state_.density;
  if (options_.viscosity == Viscosity::morris)
    coefficients_.viscosity = state_.density * options_.kinematic_viscosity;
}

template <int D>
void WeaklyCompressible<D>::fill_cloud() {
  position_ = cloud_.position();
  velocity_ = cloud_.add("velocity", FieldKind::vector, "m/s");
  density_ = cloud_.add("density", FieldKind::scalar, "kg/m3");
  pressure_ = cloud_.add("pressure", FieldKind::scalar, "Pa");
  body_ = cloud_.add("body", FieldKind::scalar, "");
  id_ = cloud_.add("id", FieldKind::scalar, "");
  if (options_.free_surface) cloud_.add("surface", FieldKind::scalar, "");
  std::ranges::copy(start_.position, position_.begin());
  for (Index i = 0; i < cloud_.count(); ++i) {
    body_[i] = start_.body[static_cast<std::size_t>(i)];
    id_[i] = i;
    if (body_of(i).kind == BodyKind::fluid) ++fluids_;
    start_particle(i);
  }
  // An assignment would keep their memory.
  std::vector<double>().swap(start_.position);
  std::vector<std::int32_t>().swap(start_.body);
}

template <int D>
void WeaklyCompressible<D>::start_particle(Index i) {
  const std::size_t first = static_cast<std::size_t>(i) * D;
  Triple place{};
  std::copy_n(position_.begin() + static_cast<std::ptrdiff_t>(first), D, place.begin());
  const bool fluid = body_of(i).kind == BodyKind::fluid;
  pressure_[i] =
      fluid || options_.walls == WallForm::dynamic ? start_.initial("pressure", place) : 0;
  density_[i] = state_.density_at(pressure_[i]);
  if (!(density_[i] > 0))
    throw InputError(
        "initial.pressure",
        fmt::format("no density has the pressure {:.6g} at x = {:.6g}", pressure_[i], place[0]));
  if (!fluid) return;
  for (std::size_t d = 0; d < D; ++d)
    velocity_[first + d] = start_.initial(std::string("velocity_") + axis_names[d], place);
}

/// Names what the integrator moves. To be called whenever the number of particles has changed.
template <int D>
void WeaklyCompressible<D>::name_parts() {
  position_ = cloud_.position();
  velocity_ = cloud_.values("velocity");
  density_ = cloud_.values("density");
  pressure_ = cloud_.values("pressure");
  body_ = cloud_.values("body");
  id_ = cloud_.values("id");
  if (options_.free_surface) surface_ = cloud_.values("surface");
  const auto count = static_cast<std::size_t>(cloud_.count());
  acceleration_.resize(count * D);
  density_rate_.resize(count);
  idle_.resize(count);
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(count))
  for (std::size_t i = 0; i < count; ++i)
    idle_[i] = body_of(static_cast<Index>(i)).kind == BodyKind::wall;
  drifted_ = {{position_, velocity_}};
  kicked_ = {{velocity_, acceleration_}};
  if (options_.density_form == FluidDensity::continuity)
    kicked_.push_back({density_, density_rate_});
}

template <int D>
const Body& WeaklyCompressible<D>::body_of(Index i) const {
  return start_.bodies[static_cast<std::size_t>(body_[i])];
}

template <int D>
const WallPlace& WeaklyCompressible<D>::place_of(Index i) const {
  return start_.wall_places[static_cast<std::size_t>(id_[i]) - static_cast<std::size_t>(fluids_)];
}

template <int D>
Triple WeaklyCompressible<D>::periods() const {
  Triple periods{};
  for (std::size_t d = 0; d < D; ++d)
    if (start_.periodic[d]) periods[d] = start_.upper[d] - start_.lower[d];
  return periods;
}

template <int D>
void WeaklyCompressible<D>::prepare(double) {
  rates_are_current_ = false;
}

template <int D>
void WeaklyCompressible<D>::start_afresh() {
  lists_are_current_ = rates_are_current_ = false;
  furthest_shift_ = 0;
}

template <int D>
void WeaklyCompressible<D>::restore(const Cloud& state) {
  for (const Field& field : cloud_.fields())
    if (!state.has(field.name) || state.count() > cloud_.count())
      throw InputError("this snapshot lacks particles or the field " + field.name);
  removed_.resume(cloud_.count() - state.count());
  cloud_ = state;
  name_parts();
  start_afresh();
}

template <int D>
void WeaklyCompressible<D>::begin_step(double time, double step) {
  now_ = time;
  move_walls(time);
  const double travel = step * (highest_speed_ + step * highest_acceleration_) + furthest_shift_;
  if (!lists_are_current_ || moved_ + 1.1 * travel > skin_ / 2) rebuild(time, travel);
  if (keeps_volume()) volume_ = volume();
  ++course_.steps;
}

template <int D>
void WeaklyCompressible<D>::update_rates_ahead(double time, double ahead) {
  if (!lists_are_current_) rebuild(time, 0);
  observe_walls(time);
  write_fluid_lines(ahead);
  if (moved_ > skin_ / 2) {
    find_neighbours();
    write_fluid_lines(ahead);
  }
  write_image_lines();
  if (options_.density_form == FluidDensity::summation) sum_densities();
  if (options_.walls == WallForm::extrapolated) write_wall_lines();
  const FluidPass pass = terms_->add_up(points_of_pairs(), neighbours_.lists(),
                                        neighbours_.pair_order(), coefficients_, sums_);
  dissipation_ = pass.dissipation;
  work_.pairs += pass.pairs;
  work_.evaluations += 1;
  work_.mean_neighbours = static_cast<double>(pass.pairs) / std::max<Index>(1, cloud_.count());
  add_operator_terms();
  add_density_correction();
  finish_rates(time, ahead);
  rates_are_current_ = true;
}

template <int D>
double WeaklyCompressible<D>::longest_step(double time, double courant) {
  if (!rates_are_current_) {
    prepare(time);
    update_rates_ahead(time, 0);
  }
  const double h = smoothing_length_;
  double step = courant * h / (state_.sound_speed + highest_speed_);
  if (highest_acceleration_ > 0)
    step = std::min(step, courant * std::sqrt(h / highest_acceleration_));
  if (options_.kinematic_viscosity > 0)
    step = std::min(step, 0.125 * h * h / options_.kinematic_viscosity);
  return step;
}

template <int D>
void WeaklyCompressible<D>::end_step(double time, double step) {
  now_ = time + step;
  course_.dissipated += dissipation_ * step;
  if (options_.shifting > 0) shift_particles(time + step, step);
  if (keeps_volume()) keep_volume();
}

/// Whether shifting acts in a fluid that fills a space between walls and periodic sides.
template <int D>
bool WeaklyCompressible<D>::keeps_volume() const {
  return options_.shifting > 0 && !options_.free_surface && !walls_travel() &&
         options_.walls == WallForm::extrapolated &&
         options_.density_form == FluidDensity::continuity;
}

template <int D>
double WeaklyCompressible<D>::volume() {
  const auto of = [&](Index i) { return is_wall(i) ? 0.0 : mass_ / density_[i]; };
  return fixed_sum(cloud_.count(), 0.0, of, volumes_);
}

/// Gives the fluid the volume again that it had at the step's start, and changes all densities
/// alike for it. The divergence's error is not 0 in the mean where particles lie irregularly and at
/// walls. Shifting lets it add up, and without a free surface the mean pressure would drift away.
template <int D>
void WeaklyCompressible<D>::keep_volume() {
  inspect();  // a density that breaks down is what happened first
  if (!(volume_ > 0)) return;
  const double growth = volume() / volume_;
  course_.swelling += growth - 1;
#pragma omp parallel for schedule(static) if (parallel_from <= cloud_.count())
  for (Index i = 0; i < cloud_.count(); ++i)
    if (!is_wall(i)) density_[i] *= growth;
}

template <int D>
void WeaklyCompressible<D>::inspect() const {
  const Index count = cloud_.count();
  Index first = count;
#pragma omp parallel for schedule(static) reduction(min : first) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i)
    if (!(density_[i] > 0.1 * state_.density && density_[i] < 10 * state_.density &&
          std::isfinite(position_[static_cast<std::size_t>(i) * D])))
      first = std::min(first, i);
  if (first == count) return;
  throw NumericalFailure(
      fmt::format("particle {} has the density {:.6g}, {:.3g} times that at rest", id_[first],
                  density_[first], density_[first] / state_.density),
      {first},
      fmt::format("the step is too long or the sound speed {:.4g} too low: the fastest particle "
                  "had {:.4g}",
                  state_.sound_speed, course_.fastest));
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace mote
