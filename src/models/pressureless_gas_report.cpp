#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mote/models/pressureless_gas.hpp"
#include "mote/particles/failure.hpp"
#include "mote/sums/sheets.hpp"

namespace mote {
namespace {

std::string cause_of_crossing(const PressurelessGasOptions& options) {
  if (options.gravity_form == GravityForm::potential)
    return "the operator's gradient of the potential is wrong where the density jumps (the printed "
           "SPH form divides by the receiver's density) and pulls neighbouring sheets together; "
           "gravity_form: sheets is exact";
  if (options.viscosity > 0)
    return "the printed Laplacian is not exact for linear velocities, so zig-zag motions grow "
           "until neighbours meet";
  return "the gas has fallen together, and a pressureless gas has no solution beyond this time, so "
         "end the run earlier; or the step is too long for these velocities";
}

}  // namespace

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
          {i, i + 1}, cause_of_crossing(options_));
  for (Index i = 0; i < cloud_.count(); ++i)
    if (!(length_[i] > 0))
      throw NumericalFailure(
          fmt::format("the cell of particle {} collapsed at x = {:.6g}", i, position_[i]), {i},
          cause_of_crossing(options_));
}

StepLimit PressurelessGas::step_limit() const {
  const double densest = std::ranges::max(density_), shortest = std::ranges::min(length_);
  double fastest = 0;
  for (const double u : velocity_) fastest = std::max(fastest, std::abs(u));
  // rho0/(1 - 2 pi G rho0 t^2) of the exact solution has no value after this time.
  const double fall = 1 / std::sqrt(2 * std::numbers::pi * options_.gravity * densest);
  StepLimit limit{fall, "the time in which the densest gas falls together"};
  const double diffusion = shortest * shortest / (2 * options_.viscosity);
  if (diffusion < limit.step) limit = {diffusion, "shortest cell^2/(2 viscosity)"};
  const double advection = shortest / fastest;
  if (frame_ == Frame::eulerian && advection < limit.step)
    limit = {advection, "the time in which the gas passes the shortest cell"};
  return limit;
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
  return {{"gravity", options_.gravity}, {"viscosity", options_.viscosity}, {"lower", lower_}};
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
  if (options_.viscosity > 0)
    remarks.emplace_back("Viscosity turns motion into heat, which the energy here leaves out.");
  const double lowest = std::ranges::min(density_);
  if (lowest < 0)
    remarks.push_back(
        fmt::format("The density is negative in places (lowest {:.3g}): central differences "
                    "oscillate where it jumps.",
                    lowest));
  return remarks;
}

}  // namespace mote
