#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/models/fixed_sum.hpp"
#include "mote/models/incompressible.hpp"

namespace mote {

/// Sum over the fluid's particles of their mass times `term(i)`.
template <int D>
template <class Term>
double Incompressible<D>::sum_over_fluid(Term term) const {
  return mass_ * fixed_sum(particles_.fluids(), 0.0, term);
}

template <int D>
std::vector<Conserved> Incompressible<D>::conserved() const {
  const double mass = sum_over_fluid([](Index) { return 1.0; });
  std::vector<Conserved> quantities{{"mass", mass, mass}};
  double speed = sum_over_fluid([&](Index i) { return particles_.velocity(i).norm(); });
  if (speed == 0) speed = mass * std::sqrt(spacing() * gravity().norm());
  if (speed == 0) speed = mass;
  for (int d = 0; d < D; ++d)
    quantities.push_back({std::string("momentum_") + axis_names[d],
                          sum_over_fluid([&](Index i) { return particles_.velocity(i)[d]; }),
                          speed});
  const double kinetic =
      sum_over_fluid([&](Index i) { return 0.5 * particles_.velocity(i).squaredNorm(); });
  const double potential =
      sum_over_fluid([&](Index i) { return -gravity().dot(particles_.position(i)); });
  quantities.push_back({"energy", kinetic + potential, kinetic + std::abs(potential)});
  return quantities;
}

template <int D>
std::vector<Reading> Incompressible<D>::readings() const {
  const double speed = highest_speed();
  return {{"kinetic_energy",
           sum_over_fluid([&](Index i) { return 0.5 * particles_.velocity(i).squaredNorm(); })},
          {"potential_energy",
           sum_over_fluid([&](Index i) { return -gravity().dot(particles_.position(i)); })},
          {"highest_speed", speed},
          {"removed", static_cast<double>(particles_.removed().count())},
          {"volume_error", course_.volume_error},
          {"divergence", speed > 0 ? course_.divergence * spacing() / speed : 0},
          {"iterations", static_cast<double>(course_.last.iterations)},
          {"residual", course_.last.residual},
          {"solver_share", course_.stepping > 0 ? course_.solving / course_.stepping : 0}};
}

template <int D>
std::vector<std::string> Incompressible<D>::remarks() const {
  const auto steps = static_cast<double>(std::max<std::int64_t>(1, course_.steps));
  return {fmt::format("{} fluid and {} wall particles, neighbours found anew {} times in {} steps.",
                      particles_.fluids(), particles_.count() - particles_.fluids(),
                      particles_.rebuilds(), course_.steps),
          fmt::format(
              "Pressure: {}, {:.3g} iterations a step to a residual of {:.1e}, {:.0f} % of the "
              "time of the steps.",
              options_.solver, static_cast<double>(course_.iterations) / steps, options_.tolerance,
              course_.stepping > 0 ? 100 * course_.solving / course_.stepping : 0.0),
          fmt::format(
              "Steps are the model's own: drift, kick, drift. {} times a particle has collided.",
              course_.collisions)};
}

template <int D>
Parameters Incompressible<D>::parameters() const {
  const SpaceStart& start = particles_.start();
  Parameters parameters{{"density", options_.density},
                        {"viscosity", options_.kinematic_viscosity},
                        {"spacing", start.spacing}};
  for (std::size_t d = 0; d < D; ++d) {
    const std::string axis = axis_names[d];
    parameters["gravity_" + axis] = gravity()[static_cast<Eigen::Index>(d)];
    parameters["lower_" + axis] = start.lower[d];
    parameters["upper_" + axis] = start.upper[d];
    parameters["periodic_" + axis] = start.periodic[d] ? 1 : 0;
  }
  return parameters;
}

/// An estimate by pairs: the forces of pressure and friction of symmetric sums over the kernel,
/// which are near those by the scenario's operator; none before the first step.
template <int D>
Triple Incompressible<D>::force_on(std::size_t body) const {
  const auto& lines = particles_.lines();
  if (course_.steps == 0) return {};
  FluidCoefficients<D> coefficients;
  coefficients.smoothing_length = smoothing_length_;
  coefficients.mass = mass_;
  coefficients.continuity = false;
  coefficients.viscosity = options_.density * options_.kinematic_viscosity;
  const std::vector<PairRole> roles(lines.size(), PairRole::plain);
  const auto& lists = particles_.lists();
  const auto of_particle = [&](Index k) -> Vec<D> {
    const Index i = particles_.fluids() + k;
    if (particles_.body_number(i) != body) return Vec<D>::Zero();
    const PairSums sums = terms_->sums_of({lines, roles}, i, lists[i], coefficients);
    return Vec<D>::Map(sums.value.data());
  };
  const Vec<D> sum = mass_ * fixed_sum(particles_.count() - particles_.fluids(),
                                       Vec<D>(Vec<D>::Zero()), of_particle);
  Triple force{};
  std::copy_n(sum.data(), D, force.begin());
  return force;
}

/// The lines that forces on walls are taken from.
template <int D>
void Incompressible<D>::complete_fields() {
  if (course_.steps == 0) return;
  show_velocities();
  show_pressure();
}

/// What the step has found, before particles may change their order: fields for snapshots, and for
/// the history the mean over the particles off the surface of how far the density is from that of
/// the lattice, and the root mean square of the divergence that the step before has left.
template <int D>
void Incompressible<D>::note_fields() {
  const Index fluids = particles_.fluids();
  std::ranges::copy(density_, cloud().values("relative_density").begin());
  if (options_.free_surface) std::ranges::copy(at_surface_, cloud().values("surface").begin());
  const auto mean_inside = [&](auto term) {
    const auto inside = [&](Index i) { return at_surface_[static_cast<std::size_t>(i)] == 0; };
    const double count = fixed_sum(fluids, 0.0, [&](Index i) { return inside(i) ? 1.0 : 0.0; });
    const double sum = fixed_sum(
        fluids, 0.0, [&](Index i) { return inside(i) ? term(static_cast<std::size_t>(i)) : 0.0; });
    return sum / std::max(1.0, count);
  };
  course_.volume_error = mean_inside([&](std::size_t k) { return density_[k] - 1; });
  course_.divergence =
      std::sqrt(mean_inside([&](std::size_t k) { return before_[k] * before_[k]; }));
}

template class Incompressible<2>;
template class Incompressible<3>;

}  // namespace mote
