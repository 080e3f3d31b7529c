#include "mote/models/pressureless_gas.hpp"
#include "mote/operators/differential/finite_difference.hpp"

namespace mote {
namespace {

constexpr Word<GravityForm> gravity_forms[] = {
    {GravityForm::sheets, "sheets", "2 pi G times the mass above less the mass below: exact"},
    {GravityForm::potential, "potential",
     "as printed: the operator's gradient of the potential, (73b)"}};

constexpr Word<DensityForm> density_forms[] = {
    {DensityForm::automatic, "automatic",
     "mass_over_volume for moving points in the gravity of sheets, continuity otherwise"},
    {DensityForm::mass_over_volume, "mass_over_volume",
     "each cell's mass over the length between its edges, (74b)"},
    {DensityForm::continuity, "continuity", "the continuity equation, (73c)"}};

constexpr Word<FrameChoice> frames[] = {
    {FrameChoice::automatic, "automatic", "eulerian for finite_difference, lagrangian otherwise"},
    {FrameChoice::lagrangian, "lagrangian", "points move with the gas, (73)"},
    {FrameChoice::eulerian, "eulerian", "points stand still, (72)"}};

constexpr Word<ViscosityScheme> viscosity_schemes[] = {
    {ViscosityScheme::implicit, "implicit",
     "a sparse solve with the operator's own weights: stable at any step"},
    {ViscosityScheme::substepped, "substepped", "as many explicit sub-steps as stability asks for"},
    {ViscosityScheme::explicit_rates, "explicit", "as printed: one rate among the others"}};

}  // namespace

void PressurelessGasOptions::describe(Description& description) {
  description.number({"gravity", "gravitational constant G"}, gravity, not_negative);
  description.number({"viscosity", "kinematic viscosity nu"}, viscosity, not_negative);
  describe_words(description, {"viscosity_scheme", "how viscosity goes on in time"},
                 viscosity_scheme, viscosity_schemes);
  description.number({"artificial_viscosity", "mu of (82), added to density and velocity a step"},
                     artificial_viscosity, not_negative);
  description.flag(
      {"smoothed_density", "whether to smooth the initial density over five points, (86)"},
      smoothed_density);
  describe_words(description, {"gravity_form", "how gravity is found"}, gravity_form,
                 gravity_forms);
  describe_words(description, {"density", "how density is found"}, density, density_forms);
  describe_words(description, {"frame", "whether the points move"}, frame, frames);
}

std::vector<InitialField> PressurelessGasRecipe::initial_fields(int /*dimension*/) const {
  return {{"density", "density at the start", ""}, {"velocity", "velocity at the start", "0"}};
}

std::unique_ptr<Model> PressurelessGasRecipe::make(LineSetup setup) const {
  return std::make_unique<PressurelessGas>(options, std::move(setup));
}

/// Sheets for gravity, masses for densities, and three points for the viscosity.
std::unique_ptr<Model> PressurelessGasRecipe::make_reference(LineSetup setup) const {
  setup.extension = 1;
  setup.differential_operator = std::make_unique<FiniteDifference<1>>();
  return std::make_unique<PressurelessGas>(
      PressurelessGasOptions{.gravity = options.gravity,
                             .viscosity = options.viscosity,
                             .density = DensityForm::mass_over_volume,
                             .frame = FrameChoice::lagrangian},
      std::move(setup));
}

}  // namespace mote
