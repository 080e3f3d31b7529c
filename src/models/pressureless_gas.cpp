#include "mote/models/pressureless_gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mote/operators/differential/apply.hpp"
#include "mote/particles/failure.hpp"
#include "mote/sums/sheets.hpp"

namespace mote {
namespace {

Frame frame_of(FrameChoice choice, const NeighbourRule& rule) {
  if (choice == FrameChoice::automatic)
    return rule.adjacent > 0 ? Frame::eulerian : Frame::lagrangian;
  return choice == FrameChoice::eulerian ? Frame::eulerian : Frame::lagrangian;
}

bool by_continuity(const PressurelessGasOptions& options, Frame frame) {
  if (frame == Frame::eulerian) return true;
  if (options.density == DensityForm::automatic)
    return options.gravity_form == GravityForm::potential || options.artificial_viscosity > 0;
  return options.density == DensityForm::continuity;
}

}  // namespace

PressurelessGas::PressurelessGas(const PressurelessGasOptions& options, LineSetup setup)
    : options_(options),
      frame_(frame_of(options.frame, setup.differential_operator->neighbour_rule())),
      continuity_(by_continuity(options, frame_)),
      operator_(std::move(setup.differential_operator)),
      extension_(static_cast<Index>(setup.extension), setup.ends, setup.lower, setup.upper),
      lower_(setup.lower),
      upper_(setup.upper),
      cloud_(1, static_cast<Index>(setup.cells.centre.size())) {
  refuse_what_does_not_go_together(setup);
  fill_cloud(setup);
  if (options.smoothed_density) smooth_density();
  make_room();
}

void PressurelessGas::refuse_what_does_not_go_together(const LineSetup& setup) const {
  const bool by_mass = options_.density == DensityForm::mass_over_volume;
  if (frame_ == Frame::eulerian && by_mass)
    throw InputError("model.density",
                     "points that stand still keep their volume, so mass_over_volume cannot give "
                     "their density; take continuity, or frame: lagrangian");
  if (options_.artificial_viscosity > 0 && by_mass)
    throw InputError("model.artificial_viscosity",
                     "artificial viscosity (82) changes the density, which mass_over_volume takes "
                     "from masses that stay; take density: continuity");
  if (setup.ends == LineEnds::wall && setup.extension > cloud_.count())
    throw InputError("domain.extension",
                     fmt::format("a wall mirrors as many particles as there are cells beyond it, "
                                 "{}, and there are only {}",
                                 setup.extension, cloud_.count()));
}

void PressurelessGas::fill_cloud(const LineSetup& setup) {
  const auto count = setup.cells.centre.size();
  position_ = cloud_.position();
  velocity_ = cloud_.add("velocity", FieldKind::vector, "m/s");
  density_ = cloud_.add("density", FieldKind::scalar, "kg/m3");
  mass_ = cloud_.add("mass", FieldKind::scalar, "kg/m2");
  length_ = cloud_.add("length", FieldKind::scalar, "m");
  length_rate_ = cloud_.add("length_rate", FieldKind::scalar, "m/s");
  for (std::size_t i = 0; i < count; ++i) {
    const double x = setup.cells.centre[i], half = 0.5 * setup.cells.length[i];
    position_[i] = x;
    length_[i] = setup.cells.length[i];
    velocity_[i] = setup.initial("velocity", x);
    density_[i] = setup.initial("density", x);
    mass_[i] = density_[i] * length_[i];
    length_rate_[i] = setup.initial("velocity", x + half) - setup.initial("velocity", x - half);
    if (!(density_[i] > 0))
      throw InputError(
          "initial.density",
          fmt::format("the density must be positive everywhere, and is {:.6g} at x = {:.6g}",
                      density_[i], x));
  }
}

/// Names what the integrator moves, and makes all room that the rates need.
void PressurelessGas::make_room() {
  const auto count = static_cast<std::size_t>(cloud_.count());
  for (auto* rate : {&acceleration_, &operator_acceleration_, &length_acceleration_, &density_rate_,
                     &derivative_})
    rate->resize(count);
  const Index points = cloud_.count() + 2 * extension_.cells();
  points_.resize(points, cloud_.count());
  fresh_points_.resize(points, cloud_.count());
  kicked_.push_back({velocity_, acceleration_});
  if (has_edges()) {
    drifted_.push_back({position_, velocity_});
    drifted_.push_back({length_, length_rate_});
    if (edges_fall_freely()) kicked_.push_back({length_rate_, length_acceleration_});
  }
  if (continuity_) drifted_.push_back({density_, density_rate_});
}

bool PressurelessGas::is_explicit() const {
  return options_.viscosity > 0 && options_.viscosity_scheme == ViscosityScheme::explicit_rates;
}

bool PressurelessGas::rates_use_operator() const {
  const bool gradient_of_potential =
      options_.gravity > 0 && options_.gravity_form == GravityForm::potential;
  return continuity_ || gradient_of_potential || is_explicit();
}

bool PressurelessGas::edges_fall_freely() const {
  return has_edges() && options_.viscosity == 0 && options_.artificial_viscosity == 0 &&
         extension_.ends() == LineEnds::zero_gradient &&
         options_.gravity_form == GravityForm::sheets;
}

void PressurelessGas::prepare(double) {
  update_dependent_fields();
  if (rates_use_operator()) prepare_operator();
}

/// Prepares the operator unless the points are as they were the last time.
void PressurelessGas::prepare_operator() {
  extension_.extend({position_, mass_, density_, length_}, fresh_points_);
  if (fresh_points_.position == points_.position && fresh_points_.length == points_.length &&
      fresh_points_.mass == points_.mass && fresh_points_.density == points_.density)
    return;
  std::swap(points_, fresh_points_);
  search_.find(points_, operator_->neighbour_rule(), lists_);
  try {
    operator_->prepare(points_, lists_);
  } catch (const NumericalFailure&) {
    inspect();  // particles that crossed are what happened first
    throw;
  }
  diffusion_is_current_ = false;
  work_.pairs += lists_.pairs();
  work_.evaluations += 1;
  work_.mean_neighbours = static_cast<double>(lists_.pairs()) / cloud_.count();
}

/// Whatever of density and mass is not carried follows from the other.
void PressurelessGas::update_dependent_fields() {
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    if (frame_ == Frame::eulerian)
      mass_[i] = density_[i] * length_[i];
    else if (!continuity_)
      density_[i] = mass_[i] / length_[i];
  }
}

std::span<const double> PressurelessGas::extended(std::span<const double> values, Parity parity) {
  field_.resize(static_cast<std::size_t>(points_.size()));
  extension_.fill(values, field_, parity);
  return field_;
}

void PressurelessGas::update_drift_rates(double) {
  if (has_edges() && !edges_fall_freely()) update_length_rates();
  if (!continuity_) return;
  if (frame_ == Frame::lagrangian) {
    divergence<1>(*operator_, lists_, extended(velocity_, Parity::odd), derivative_);
    for (std::size_t i = 0; i < density_.size(); ++i)
      density_rate_[i] = -density_[i] * derivative_[i];  // (73c)
  } else {
    for (std::size_t i = 0; i < density_.size(); ++i) density_rate_[i] = density_[i] * velocity_[i];
    divergence<1>(*operator_, lists_, extended(density_rate_, Parity::odd), derivative_);
    for (std::size_t i = 0; i < density_.size(); ++i) density_rate_[i] = -derivative_[i];  // (72a)
  }
  hold_ends(density_rate_);
}

void PressurelessGas::update_kick_rates(double) {
  std::ranges::fill(operator_acceleration_, 0.0);
  add_gravity_of_potential();
  if (is_explicit()) add_viscosity();
  add_advection();
  const bool sheets = options_.gravity_form == GravityForm::sheets;
  sheet_acceleration(mass_, sheets ? options_.gravity : 0, acceleration_);
  for (std::size_t i = 0; i < acceleration_.size(); ++i)
    acceleration_[i] += operator_acceleration_[i];
  hold_ends(acceleration_);
  if (!edges_fall_freely()) return;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    length_acceleration_[i] = -4 * std::numbers::pi * options_.gravity * mass_[i];
}

/// (89): the end particles keep what they have.
void PressurelessGas::hold_ends(std::span<double> rates) const {
  if (extension_.ends() == LineEnds::held) rates.front() = rates.back() = 0;
}

/// -Pi' by the operator's gradient of the potential, as printed in (73b).
void PressurelessGas::add_gravity_of_potential() {
  if (options_.gravity_form != GravityForm::potential || options_.gravity == 0) return;
  field_.resize(static_cast<std::size_t>(points_.size()));
  mass_below_.resize(mass_.size() + 1);
  moment_below_.resize(mass_.size() + 1);
  sheet_potential(position_, mass_, options_.gravity, points_.position, mass_below_, moment_below_,
                  field_);
  gradient<1>(*operator_, lists_, field_, derivative_);
  for (std::size_t i = 0; i < derivative_.size(); ++i) operator_acceleration_[i] -= derivative_[i];
}

/// nu u'' of (81b).
void PressurelessGas::add_viscosity() {
  laplacian<1>(*operator_, lists_, extended(velocity_, Parity::odd), derivative_);
  for (std::size_t i = 0; i < derivative_.size(); ++i)
    operator_acceleration_[i] += options_.viscosity * derivative_[i];
}

/// -u u' of (72b), for points that stand still.
void PressurelessGas::add_advection() {
  if (frame_ != Frame::eulerian) return;
  gradient<1>(*operator_, lists_, extended(velocity_, Parity::odd), derivative_);
  for (std::size_t i = 0; i < derivative_.size(); ++i)
    operator_acceleration_[i] -= velocity_[i] * derivative_[i];
}

/// (74a): every edge moves with the mean of its two particles; a wall stands, and a free end moves
/// with its particle.
void PressurelessGas::update_length_rates() {
  const std::size_t last = velocity_.size() - 1;
  const double lower_end = extension_.sign(Parity::odd) * velocity_[0];
  const double upper_end = extension_.sign(Parity::odd) * velocity_[last];
  for (std::size_t i = 0; i <= last; ++i)
    length_rate_[i] =
        0.5 * ((i < last ? velocity_[i + 1] : upper_end) - (i > 0 ? velocity_[i - 1] : lower_end));
}

}  // namespace mote
