#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/models/fixed_sum.hpp"
#include "mote/models/weakly_compressible.hpp"

namespace mote {

/// Sum over the fluid's particles of their mass times `term(i)`.
template <int D>
template <class Term>
double WeaklyCompressible<D>::sum_over_fluid(Term term) const {
  return mass_ *
         fixed_sum(cloud_.count(), 0.0, [&](Index i) { return is_wall(i) ? 0.0 : term(i); });
}

template <int D>
typename WeaklyCompressible<D>::Energy WeaklyCompressible<D>::energy() const {
  const auto vector = [](std::span<const double> values, Index i) {
    return Vec<D>::Map(values.data() + std::ptrdiff_t{i} * D);
  };
  Energy energy;
  energy.kinetic =
      sum_over_fluid([&](Index i) { return 0.5 * vector(velocity_, i).squaredNorm(); });
  energy.potential = sum_over_fluid([&](Index i) { return -gravity().dot(vector(position_, i)); });
  energy.compression = sum_over_fluid([&](Index i) { return state_.energy(density_[i]); });
  return energy;
}

template <int D>
std::vector<Conserved> WeaklyCompressible<D>::conserved() const {
  const double mass = sum_over_fluid([](Index) { return 1.0; });
  std::vector<Conserved> quantities{{"mass", mass, mass}};
  double speed = sum_over_fluid(
      [&](Index i) { return Vec<D>::Map(velocity_.data() + std::ptrdiff_t{i} * D).norm(); });
  if (speed == 0) speed = mass * state_.sound_speed;
  for (std::size_t d = 0; d < D; ++d) {
    const double momentum =
        sum_over_fluid([&](Index i) { return velocity_[static_cast<std::size_t>(i) * D + d]; });
    quantities.push_back({std::string("momentum_") + axis_names[d], momentum, speed});
  }
  const Energy parts = energy();
  quantities.push_back({"energy", parts.total(),
                        std::abs(parts.kinetic) + std::abs(parts.potential) + parts.compression});
  return quantities;
}

template <int D>
std::vector<Reading> WeaklyCompressible<D>::readings() const {
  const Energy parts = energy();
  std::vector<Reading> readings{
      {"kinetic_energy", parts.kinetic},
      {"potential_energy", parts.potential},
      {"compression_energy", parts.compression},
      {"viscous_power", dissipation_},
      {"highest_speed", highest_speed_},
      {"removed", static_cast<double>(fluids_ - static_cast<Index>(std::ranges::count(idle_, 0)))}};
  if constexpr (D == 2) {  // about the origin
    const auto moment = [&](Index i) {
      const double *x = &position_[i * 2], *u = &velocity_[i * 2];
      return x[0] * u[1] - x[1] * u[0];
    };
    readings.push_back({"angular_momentum", sum_over_fluid(moment)});
  }
  return readings;
}

template <int D>
std::vector<std::string> WeaklyCompressible<D>::warnings() const {
  std::vector<std::string> warnings;
  if (course_.fastest > 0.1 * state_.sound_speed * (1 + 1e-3))
    warnings.push_back(fmt::format(
        "the sound speed {:.4g} is less than ten times the highest speed, {:.4g} at t = {:.4g}: "
        "the fluid is compressed by more than 1 %",
        state_.sound_speed, course_.fastest, course_.fastest_at));
  std::ranges::copy(removed_.warnings(), std::back_inserter(warnings));
  return warnings;
}

template <int D>
std::vector<std::string> WeaklyCompressible<D>::remarks() const {
  const Energy now = energy();
  std::vector<std::string> remarks{
      fmt::format("{} fluid and {} wall particles, smoothing length {:.4g} ({:.3g} spacings), "
                  "neighbours found anew {} times in {} steps.",
                  std::ranges::count(idle_, 0), std::ranges::count(idle_, 1), smoothing_length_,
                  smoothing_length_ / start_.spacing, course_.rebuilds, course_.steps),
      fmt::format("Energy at the end: kinetic {:.6g}, potential {:.6g}, of compression {:.6g}; "
                  "viscosity took {:.6g}.",
                  now.kinetic, now.potential, now.compression, course_.dissipated)};
  if (keeps_volume())
    remarks.push_back(fmt::format(
        "The fluid's volume was kept: numerical errors would have changed it by {:.2g} of itself.",
        course_.swelling));
  return remarks;
}

template <int D>
Parameters WeaklyCompressible<D>::parameters() const {
  Parameters parameters{{"density", state_.density},
                        {"sound_speed", state_.sound_speed},
                        {"viscosity", options_.kinematic_viscosity},
                        {"spacing", start_.spacing}};
  for (std::size_t d = 0; d < D; ++d) {
    const std::string axis = axis_names[d];
    parameters["gravity_" + axis] = gravity()[static_cast<Eigen::Index>(d)];
    parameters["lower_" + axis] = start_.lower[d];
    parameters["upper_" + axis] = start_.upper[d];
    parameters["periodic_" + axis] = start_.periodic[d] ? 1 : 0;
  }
  return parameters;
}

/// The pair forces on the wall's particles, as they act on the fluid with the opposite sign; none
/// before neighbours are known.
template <int D>
Triple WeaklyCompressible<D>::force_on(std::size_t body) const {
  const auto& lists = neighbours_.lists();
  FluidCoefficients<D> coefficients = coefficients_;
  coefficients.pressure = true;
  coefficients.viscosity = state_.density * options_.kinematic_viscosity;
  const auto of_particle = [&](Index i) -> Vec<D> {
    if (static_cast<std::size_t>(body_[i]) != body) return Vec<D>::Zero();
    const PairSums sums = terms_->sums_of({lines_, roles_}, i, lists[i], coefficients);
    return Vec<D>::Map(sums.value.data());
  };
  const Vec<D> sum = mass_ * fixed_sum(lists.receivers(), Vec<D>(Vec<D>::Zero()), of_particle);
  Triple force{};
  std::copy_n(sum.begin(), D, force.begin());
  return force;
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace mote
