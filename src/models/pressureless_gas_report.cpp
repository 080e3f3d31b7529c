#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "mote/models/pressureless_gas.hpp"
#include "mote/particles/failure.hpp"
#include "mote/sums/sheets.hpp"

namespace mote {

std::string PressurelessGas::cause_of_crossing() const {
  if (options_.gravity_form == GravityForm::potential && options_.gravity > 0)
    return "the operator's gradient of the potential is wrong where the density jumps (the printed "
           "SPH form divides by the receiver's density) and pulls neighbouring sheets together; "
           "gravity_form: sheets is exact";
  if (course_.passed())
    return fmt::format(
        "the step was beyond the stability limit of explicit viscosity, {:.4g} at "
        "t = {:.6g}; viscosity_scheme: implicit has none",
        course_.passed_limit, course_.passed_at);
  const double shortest = std::ranges::min(length_);
  if (options_.artificial_viscosity > 0.5 * shortest * shortest)
    return fmt::format(
        "artificial viscosity (82) of {:.3g} a step is more than half the square of the shortest "
        "cell, {:.3g}, beyond which it grows without bound",
        options_.artificial_viscosity, shortest);
  if (options_.viscosity > 0)
    return "if the operator's Laplacian is not exact for linear velocities (printed SPH, and MPS "
           "on points of uneven spacing), it pushes neighbours together; morris, corrected_sph, "
           "least_squares and finite_difference are made for this. Or the viscosity is too small "
           "for the distance of the particles, or the gas at the ends has met";
  return "the gas has fallen together, and a pressureless gas has no solution beyond this time, so "
         "end the run earlier; or the step is too long for these velocities";
}

void PressurelessGas::inspect() const {
  for (const Field& field : cloud_.fields())
    for (Index i = 0; i < cloud_.count(); ++i)
      if (!std::isfinite(field.values[i]))
        throw NumericalFailure(
            fmt::format("the {} of particle {} is no longer a finite number", field.name, i), {i},
            "the step is too long, or the operator is unstable here");
  for (Index i = 0; i + 1 < cloud_.count(); ++i)
    if (!(position_[i] < position_[i + 1]))
      throw NumericalFailure(
          fmt::format("particles {} and {} crossed at x = {:.6g}", i, i + 1, position_[i]),
          {i, i + 1}, cause_of_crossing());
  for (const Index i : {Index{0}, cloud_.count() - 1})
    if (extension_.ends() == LineEnds::wall && !(position_[i] > lower_ && position_[i] < upper_))
      throw NumericalFailure(
          fmt::format("particle {} passed the wall, to x = {:.6g}", i, position_[i]), {i},
          cause_of_crossing());
  for (Index i = 0; i < cloud_.count(); ++i)
    if (!(length_[i] > 0))
      throw NumericalFailure(
          fmt::format("the cell of particle {} collapsed at x = {:.6g}", i, position_[i]), {i},
          cause_of_crossing());
}

std::vector<StepLimit> PressurelessGas::step_limits() {
  const double densest = std::ranges::max(density_), shortest = std::ranges::min(length_);
  double fastest = 0;
  for (const double u : velocity_) fastest = std::max(fastest, std::abs(u));
  // rho0/(1 - 2 pi G rho0 t^2) of the exact solution has no value after this time.
  std::vector<StepLimit> limits{{1 / std::sqrt(2 * std::numbers::pi * options_.gravity * densest),
                                 "the time in which the densest gas falls together"}};
  if (frame_ == Frame::eulerian)
    limits.push_back({shortest / fastest, "the time in which the gas passes the shortest cell"});
  if (options_.artificial_viscosity > 0.5 * shortest * shortest)
    limits.push_back(
        {0,
         fmt::format("artificial viscosity (82) of {:.3g} in every step, however short, is more "
                     "than half the square of the shortest cell, {:.3g}",
                     options_.artificial_viscosity, shortest),
         true});
  if (is_explicit())
    limits.push_back(
        {explicit_limit(),
         "1/(viscosity times the largest sum of the Laplacian's weights), beyond which "
         "explicit viscosity may grow without bound",
         true});
  return limits;
}

std::vector<Conserved> PressurelessGas::conserved() const {
  double mass = 0, momentum = 0, momentum_scale = 0, kinetic = 0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    mass += mass_[i];
    momentum += mass_[i] * velocity_[i];
    momentum_scale += std::abs(mass_[i] * velocity_[i]);
    kinetic += 0.5 * mass_[i] * velocity_[i] * velocity_[i];
  }
  const double potential = sheet_energy(position_, mass_, options_.gravity);
  return {{"mass", mass, std::abs(mass)},
          {"momentum", momentum, momentum_scale},
          {"energy", kinetic + potential, kinetic + std::abs(potential)}};
}

Parameters PressurelessGas::parameters() const {
  return {{"gravity", options_.gravity},
          {"viscosity", options_.viscosity},
          {"lower", lower_},
          {"upper", upper_},
          {"smoothed", options_.smoothed_density ? 1 : 0},
          {"walls", extension_.ends() == LineEnds::wall ? 1 : 0},
          {"standing", frame_ == Frame::eulerian ? 1 : 0}};
}

std::vector<std::string> PressurelessGas::remarks() const {
  std::vector<std::string> remarks;
  remarks.emplace_back(frame_ == Frame::lagrangian ? "The points move with the gas (Lagrangian)."
                                                   : "The points stand still (Eulerian).");
  remarks.emplace_back(options_.gravity_form == GravityForm::sheets
                           ? "Gravity is summed from the sheets directly."
                           : "Gravity is the operator's gradient of the potential, as printed.");
  remarks.emplace_back(continuity_ ? "Density comes from the continuity equation."
                                   : "Density is each cell's mass over its length.");
  if (!uses_operator())
    remarks.emplace_back("So nothing in this run needs a derivative: the operator was not used.");
  if (frame_ == Frame::eulerian && extension_.ends() != LineEnds::wall)
    remarks.emplace_back("What flows through the ends counts as drift of mass and momentum.");
  std::ranges::copy(remarks_on_viscosity(), std::back_inserter(remarks));
  if (!smoothing_.empty()) remarks.push_back(smoothing_);
  const double lowest = std::ranges::min(density_);
  if (lowest < 0)
    remarks.push_back(
        fmt::format("The density is negative in places (lowest {:.3g}): central differences "
                    "oscillate where it jumps.",
                    lowest));
  return remarks;
}

std::vector<std::string> PressurelessGas::remarks_on_viscosity() const {
  std::vector<std::string> remarks;
  if (options_.viscosity > 0)
    remarks.emplace_back("Viscosity turns motion into heat, which the energy here leaves out.");
  if (course_.substeps > 0)
    remarks.push_back(
        fmt::format("Viscosity took {} sub-steps in {} steps since the run was started or resumed, "
                    "{} at most in half a step.",
                    course_.substeps, course_.steps, course_.most_substeps));
  if (options_.artificial_viscosity > 0) {
    const double equivalent = options_.artificial_viscosity / course_.step;
    remarks.push_back(fmt::format(
        "Artificial viscosity (82), mu = {:.3g}, was added in each of {} steps since the run "
        "was started or resumed: as much as a kinematic viscosity of {:.3g}{}. It moved {:.3g} of "
        "mass (sum of |change of density| dx) "
        "and {:.3g} of velocity (sum of |change| dx).",
        options_.artificial_viscosity, course_.steps, equivalent,
        options_.viscosity > 0
            ? fmt::format(", {:.3g} % of the model's own", 100 * equivalent / options_.viscosity)
            : "",
        course_.mass_moved, course_.velocity_moved));
  }
  return remarks;
}

}  // namespace mote
