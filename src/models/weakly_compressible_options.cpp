#include "mote/models/weakly_compressible_options.hpp"

#include "mote/models/weakly_compressible.hpp"

namespace mote {
namespace {

constexpr Word<StateEquation> state_equations[] = {
    {StateEquation::linear, "linear", "p = c^2 (rho - rho0)"},
    {StateEquation::tait, "tait", "p = B ((rho/rho0)^gamma - 1), B = rho0 c^2/gamma"}};

constexpr Word<FluidDensity> densities[] = {
    {FluidDensity::continuity, "continuity", "carried by D rho/Dt = -rho div u"},
    {FluidDensity::summation, "summation", "sum of the neighbours' masses; not for free surfaces"}};

constexpr Word<Derivatives> derivatives[] = {
    {Derivatives::pairs, "pairs", "in symmetric pairs, which keep momentum"},
    {Derivatives::by_operator, "operator", "by the scenario's operator"}};

constexpr Word<Viscosity> viscosities[] = {
    {Viscosity::none, "none", "no viscosity"},
    {Viscosity::morris, "morris", "in pairs (Morris, Fox & Zhu 1997)"},
    {Viscosity::artificial, "artificial", "between particles that approach (Monaghan 1992)"},
    {Viscosity::by_operator, "operator", "by the Laplacian of the scenario's operator"}};

constexpr Word<DensityDiffusion> diffusions[] = {
    {DensityDiffusion::none, "none", "no density diffusion"},
    {DensityDiffusion::molteni, "molteni", "of the density (Molteni & Colagrossi 2009)"},
    {DensityDiffusion::fourtakas, "fourtakas",
     "of what differs from the density at rest (Fourtakas et al. 2019)"},
    {DensityDiffusion::antuono, "antuono",
     "of what differs from a linear density (Antuono et al. 2010)"}};

constexpr Word<WallForm> wall_forms[] = {
    {WallForm::extrapolated, "extrapolated",
     "pressure and velocity go on from the fluid into the wall (Adami et al. 2012)"},
    {WallForm::dynamic, "dynamic", "density by continuity, as in the fluid (Crespo et al. 2007)"}};

void describe_viscosity(Description& d, WeaklyCompressibleOptions& options) {
  describe_words(d, {"type", "how viscosity acts"}, options.viscosity, viscosities);
  d.number({"kinematic", "kinematic viscosity nu, for morris and operator"},
           options.kinematic_viscosity, not_negative);
  d.number({"alpha", "strength of the artificial viscosity"}, options.alpha, not_negative);
}

void describe_diffusion(Description& d, WeaklyCompressibleOptions& options) {
  describe_words(d, {"type", "which diffusion"}, options.diffusion, diffusions);
  d.number({"strength", "delta"}, options.diffusion_strength, not_negative);
}

}  // namespace

void WeaklyCompressibleOptions::describe(Description& d) {
  d.number({"density", "rho0"}, density, positive);
  d.number({"sound_speed", "c, ten times the speeds that occur", true}, sound_speed, positive);
  describe_words(d, {"equation_of_state", "pressure from density"}, equation_of_state,
                 state_equations);
  d.number({"exponent", "gamma of tait"}, exponent, positive);
  d.number({"background_pressure", "pressure at rho0"}, background_pressure);
  describe_words(d, {"density_form", "where the density comes from"}, density_form, densities);
  describe_words(d, {"pressure", "how its gradient is formed"}, pressure, derivatives);
  describe_words(d, {"divergence", "how the divergence of the velocity is formed"}, divergence,
                 derivatives);
  d.section({"viscosity", "friction in the fluid and at walls"},
            [&] { describe_viscosity(d, *this); });
  d.section({"density_diffusion", "against noise in the pressure"},
            [&] { describe_diffusion(d, *this); });
  d.number({"shifting", "strength of particle shifting; 0: none"}, shifting, not_negative);
  d.flag({"free_surface",
          "whether there may be one, which shifting then spares; where there is none "
          "it keeps the fluid's volume"},
         free_surface);
  body_force.describe(d);
  describe_words(d, {"walls", "what wall particles are"}, walls, wall_forms);
}

std::vector<InitialField> WeaklyCompressibleRecipe::initial_fields(int dimension) const {
  std::vector<InitialField> fields;
  for (int d = 0; d < dimension; ++d)
    fields.push_back({std::string("velocity_") + axis_names[d],
                      std::string("velocity along ") + axis_names[d], "0"});
  fields.push_back({"pressure", "pressure; the density follows from it", "0"});
  return fields;
}

std::vector<std::string> WeaklyCompressibleRecipe::conserved_names(int dimension) const {
  std::vector<std::string> names{"mass"};
  for (int d = 0; d < dimension; ++d) names.push_back(std::string("momentum_") + axis_names[d]);
  names.push_back("energy");
  return names;
}

std::unique_ptr<Model> WeaklyCompressibleRecipe::make(SpaceSetup setup) const {
  if (setup.dimension == 2)
    return std::make_unique<WeaklyCompressible<2>>(options, std::move(setup));
  return std::make_unique<WeaklyCompressible<3>>(options, std::move(setup));
}

}  // namespace mote
