#include "mote/models/incompressible_options.hpp"

#include "mote/models/incompressible.hpp"
#include "mote/solvers/linear_solver.hpp"

namespace mote {
namespace {

constexpr Word<PressureSource> sources[] = {
    {PressureSource::divergence, "divergence", "of the velocity that pressure has not yet changed"},
    {PressureSource::density, "density",
     "deviation of the number density from n0 (Koshizuka & Oka 1996)"},
    {PressureSource::mixed, "mixed",
     "divergence, with what errors of density and divergence are left compensated (Khayyer & Gotoh "
     "2011)"}};

constexpr Word<PressureGradient> gradients[] = {
    {PressureGradient::plain, "plain", "sum of g_ij (p_j - p_i)"},
    {PressureGradient::repulsive, "repulsive",
     "sum of g_ij (p_j - p_min), p_min the least around, which keeps particles apart (Koshizuka & "
     "Oka 1996)"},
    {PressureGradient::symmetric, "symmetric",
     "sum of g_ij (p_j + p_i), which keeps momentum where g_ij = -g_ji"}};

constexpr Word<PressureLaplacian> laplacians[] = {
    {PressureLaplacian::by_operator, "operator", "by the scenario's operator"},
    {PressureLaplacian::mps, "mps",
     "of the pressure by mps with the constants of a lattice, which makes a symmetric matrix of "
     "any "
     "neighbours"}};

constexpr Word<SurfaceTest> surface_tests[] = {
    {SurfaceTest::number_density, "number_density", "where it is below threshold times n0"},
    {SurfaceTest::cone, "cone",
     "where no neighbour lies in a cone of 45 degrees outwards (Marrone et al. 2010)"},
    {SurfaceTest::missing_neighbours, "missing_neighbours",
     "none: neighbours that are missing to n0 are thought to have the pressure -p_i, so that it is "
     "0 "
     "half way to them; needs 'laplacian: mps' or mps itself with 'constants: lattice'"}};

void describe_surface(Description& d, IncompressibleOptions& options) {
  describe_words(d, {"test", "which particles belong to the surface"}, options.surface_test,
                 surface_tests);
  d.number({"threshold", "of number_density, in n0"}, options.surface_threshold, {0.1, 1});
}

}  // namespace

IncompressibleOptions::IncompressibleOptions() : solver(solver_names().front().name) {}

void IncompressibleOptions::describe(Description& d) {
  d.number({"density", "rho0"}, density, positive);
  d.number({"kinematic_viscosity", "nu"}, kinematic_viscosity, not_negative);
  d.section({"source", "right side of the pressure equation"}, [&] {
    describe_words(d, {"type", "what it is made of"}, source, sources);
    d.number(
        {"relaxation", "part of a density deviation that a step of mixed, or density, removes"},
        relaxation, {0, 1});
  });
  describe_words(d, {"gradient", "how the pressure's gradient is formed"}, gradient, gradients);
  describe_words(d, {"laplacian", "how its Laplacian is formed"}, laplacian, laplacians);
  d.flag({"tension", "whether the fluid bears negative pressures; without, they act as 0"},
         tension);
  d.flag({"free_surface", "whether there is one, at which the pressure is 0"}, free_surface);
  d.section({"surface", "how the free surface is found"}, [&] { describe_surface(d, *this); });
  d.number(
      {"mean_pressure", "mean of the pressure, which nothing else fixes without a free surface"},
      mean_pressure);
  d.number({"shifting", "strength of particle shifting; 0: none"}, shifting, not_negative);
  d.section({"collisions", "of particles that come too close"}, [&] {
    d.number({"distance", "in spacings, below which they collide; 0: never"}, collision_distance,
             {0, 1});
    d.number({"restitution", "part of their approach that they part with"}, restitution, {0, 1});
  });
  d.section({"solver", "of the pressure equation"}, [&] {
    d.choice({"name", "what preconditions the iterations"}, solver, solver_names());
    d.number({"tolerance", "residual over right side at which it stops"}, tolerance, positive);
    d.count({"most_iterations", "after which it has failed"}, most_iterations, {1, 1e6});
  });
  body_force.describe(d);
}

std::vector<InitialField> IncompressibleRecipe::initial_fields(int dimension) const {
  std::vector<InitialField> fields;
  for (int d = 0; d < dimension; ++d)
    fields.push_back({std::string("velocity_") + axis_names[d],
                      std::string("velocity along ") + axis_names[d], "0"});
  fields.push_back({"pressure", "pressure, where the first solution starts from", "0"});
  return fields;
}

std::vector<std::string> IncompressibleRecipe::conserved_names(int dimension) const {
  std::vector<std::string> names{"mass"};
  for (int d = 0; d < dimension; ++d) names.push_back(std::string("momentum_") + axis_names[d]);
  names.push_back("energy");
  return names;
}

std::unique_ptr<Model> IncompressibleRecipe::make(SpaceSetup setup) const {
  if (setup.dimension == 2) return std::make_unique<Incompressible<2>>(options, std::move(setup));
  return std::make_unique<Incompressible<3>>(options, std::move(setup));
}

}  // namespace mote
