#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/models/pressureless_gas.hpp"

namespace mote {
namespace {

/// Mean over the value and two on each side, which repeat the end values beyond the ends.
std::vector<double> five_point_mean(std::span<const double> values) {
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  std::vector<double> mean(values.size());
  for (std::ptrdiff_t i = 0; i <= last; ++i)
    for (std::ptrdiff_t k = i - 2; k <= i + 2; ++k)
      mean[i] += values[std::clamp<std::ptrdiff_t>(k, 0, last)] / 5;
  return mean;
}

/// (82) on one field: f_i + mu/dx_i^2 (f_i+1 - 2 f_i + f_i-1), with what lies beyond the ends; the
/// first and last value stay if `held`. Returns sum |change| dx.
double add_second_difference(double mu, std::span<const double> length, std::span<double> values,
                             std::array<double, 2> beyond, bool held) {
  double before = beyond[0], moved = 0;
  const std::size_t last = values.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double old = values[i], after = i < last ? values[i + 1] : beyond[1];
    const double change = mu / (length[i] * length[i]) * (after - 2 * old + before);
    before = old;
    if (held && (i == 0 || i == last)) continue;
    values[i] += change;
    moved += std::abs(change) * length[i];
  }
  return moved;
}

}  // namespace

/// (86): the initial density, and with it the mass, as a running mean.
void PressurelessGas::smooth_density() {
  const std::vector<double> smooth = five_point_mean(density_);
  double before = 0, after = 0, largest = 0;
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    largest = std::max(largest, std::abs(smooth[i] - density_[i]));
    before += mass_[i];
    density_[i] = smooth[i];
    mass_[i] = density_[i] * length_[i];
    after += mass_[i];
  }
  smoothing_ = fmt::format(
      "The initial density was smoothed once over five points, (86), in {} cells: it changed by up "
      "to {:.3g}, the mass from {:.6g} to {:.6g}.",
      smooth.size(), largest, before, after);
}

void PressurelessGas::begin_step(double time, double step) {
  course_.step = step;
  course_.steps += 1;
  if (is_explicit())
    note_step_limit(time, step);
  else
    add_viscosity_over(step / 2);
}

void PressurelessGas::end_step(double, double step) {
  inspect();
  if (!is_explicit()) add_viscosity_over(step / 2);
  if (options_.artificial_viscosity > 0) add_artificial_viscosity();
}

/// nu u'' of (81b) over a time in which the points stand still.
void PressurelessGas::add_viscosity_over(double time) {
  if (options_.viscosity == 0) return;
  update_dependent_fields();
  prepare_operator();
  if (!diffusion_is_current_) diffusion_.assemble(*operator_, lists_, extension_);
  diffusion_is_current_ = true;
  if (options_.viscosity_scheme == ViscosityScheme::implicit)
    return diffusion_.advance_implicitly(options_.viscosity * time, velocity_);
  const auto substeps = diffusion_.advance_in_substeps(options_.viscosity * time, velocity_);
  course_.substeps += substeps;
  course_.most_substeps = std::max(course_.most_substeps, substeps);
}

void PressurelessGas::add_artificial_viscosity() {
  const double mu = options_.artificial_viscosity;
  const bool held = extension_.ends() == LineEnds::held;
  const double mirrored = extension_.sign(Parity::odd);
  course_.mass_moved +=
      add_second_difference(mu, length_, density_, {density_.front(), density_.back()}, held);
  course_.velocity_moved += add_second_difference(
      mu, length_, velocity_, {mirrored * velocity_.front(), mirrored * velocity_.back()}, held);
}

/// The longest stable step of explicit viscosity with the points as they are.
double PressurelessGas::explicit_limit() {
  update_dependent_fields();
  prepare_operator();
  const auto [receiver, sum] = largest_row_sum(*operator_, lists_, extension_.ends());
  return 1 / (options_.viscosity * sum);
}

void PressurelessGas::note_step_limit(double time, double step) {
  if (course_.passed()) return;
  const double limit = explicit_limit();
  // Steps are rounded to hit the snapshots, so one at the limit may lie a rounding above it.
  if (step <= limit * (1 + 1e-12)) return;
  course_.passed_at = time;
  course_.passed_limit = limit;
}

std::vector<std::string> PressurelessGas::warnings() const {
  if (!course_.passed()) return {};
  return {
      fmt::format("from t = {:.6g} on the step {:.6g} was beyond the stability limit {:.4g} of "
                  "explicit viscosity; implicit or substepped viscosity has none",
                  course_.passed_at, course_.step, course_.passed_limit)};
}

}  // namespace mote
