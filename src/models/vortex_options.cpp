#include "mote/models/vortex_options.hpp"

#include <algorithm>

#include "mote/models/induced_velocity.hpp"
#include "mote/models/vortex.hpp"
#include "mote/models/vortex_outlines.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

constexpr Word<Diffusion> diffusions[] = {
    {Diffusion::none, "none", "a fluid without friction"},
    {Diffusion::sph, "sph",
     "the Laplacian of the scenario's operator, d omega/dt = nu lap omega (Isshiki 2014, (37) to "
     "(44)); its circulation is not kept exactly"},
    {Diffusion::particle_strength_exchange, "particle_strength_exchange",
     "pairs exchange circulation (Degond & Mas-Gallic 1989)"},
    {Diffusion::core_spreading, "core_spreading",
     "gauss cores grow, the square of their size by 2 nu t (Leonard 1980)"},
    {Diffusion::random_walk, "random_walk",
     "vortices move at random by sqrt(2 nu t) (Chorin 1973)"}};

constexpr Word<Remeshing> remeshings[] = {
    {Remeshing::m4_prime, "m4_prime",
     "on 4 nodes an axis, which keep circulation and both impulses (Monaghan 1985)"},
    {Remeshing::gauss, "gauss",
     "for core_spreading: a Gauss function as wide as the cores have grown, which then begin again "
     "at their size; waits until that is 1.3 spacings"}};

const Choices sums{{"automatic", "direct for few vortices, multipole for many"},
                   {"direct", "pair by pair"},
                   {"multipole", "an adaptive fast multipole method"}};

void describe_core(Description& d, VortexOptions& options) {
  d.variant(
      {"name", "its form"}, options.core, vortex_core_choices(), [&](const std::string& name) {
        if (name == "point") return;
        d.number({"overlap", "its size in spacings; default: 1.5"}, options.overlap, positive);
        d.number({"size", "its size itself, in place of 'overlap'"}, options.core_size, positive);
      });
}

void describe_diffusion(Description& d, VortexOptions& options) {
  Choices choices;
  std::string type;
  for (const auto& word : diffusions) {
    choices.push_back({std::string(word.name), std::string(word.summary)});
    if (word.value == options.diffusion) type = word.name;
  }
  d.variant({"type", "which way"}, type, choices, [&](const std::string& chosen) {
    for (const auto& word : diffusions)
      if (word.name == chosen) options.diffusion = word.value;
    if (chosen == "sph")
      d.number({"floor",
                "vorticity over its highest below which a vortex keeps its circulation: there "
                "operators lack neighbours, and vortex_blob divides by next to nothing"},
               options.floor, {0, 1});
    if (chosen == "particle_strength_exchange")
      d.number({"range", "of the exchange, exp(-(r/range)^2), in spacings"}, options.exchange_range,
               {0.8, 10});
    if (chosen == "random_walk") d.count({"seed", "of its steps"}, options.seed, not_negative);
  });
}

void describe_remeshing(Description& d, VortexOptions& options) {
  d.count({"every", "so many steps; 0: never"}, options.remesh_every, not_negative);
  describe_words(d, {"kernel", "what carries vorticity over"}, options.remeshing, remeshings);
}

void describe_vortex(Description& d, SingleVortex& vortex) {
  d.numbers({"position", "one number a dimension", true}, vortex.position);
  d.number({"circulation", "positive: counter-clockwise", true}, vortex.circulation);
}

[[noreturn]] void refuse(const std::string& key, const std::string& message) {
  throw InputError("model." + key, message);
}

}  // namespace

void VortexOptions::describe(Description& d) {
  d.section({"core", "how the circulation of a vortex is spread"},
            [&] { describe_core(d, *this); });
  d.section({"sum", "how velocities are summed in the unbounded plane"}, [&] {
    d.choice({"method", "which way"}, sum, sums);
    d.number({"tolerance", "of the multipole method: error over the largest velocity"}, tolerance,
             {1e-13, 1e-2});
  });
  d.number({"kinematic_viscosity", "nu"}, kinematic_viscosity, not_negative);
  d.section({"diffusion",
             "how it spreads vorticity; beside walls there is one way alone: each step ends with "
             "vortices on the nodes of a lattice that walls cut, which exchange circulation"},
            [&] { describe_diffusion(d, *this); });
  d.section({"remesh", "putting the vortices back on a lattice from the domain's lower corner on"},
            [&] { describe_remeshing(d, *this); });
  d.number({"panel_length",
            "of walls, at most, in spacings: walls are regions that are one box, ball or polygon, "
            "made of panels along the outline, which stand still and where the fluid sticks"},
           panel_length, {0.5, 10});
  d.number({"threshold",
            "vorticity over its highest below which the start and remeshing leave a place empty; "
            "the circulation and impulses that this takes are given back to the others, beside "
            "walls to the walls (there forces "
            "want 1e-6 or less)"},
           threshold, {0, 0.1});
  d.expressions({"free_stream",
                 "velocity far away in x, y and t, one formula a dimension, free of divergence and "
                 "rotation; default: none"},
                free_stream);
  describe_list(d, {"vortices", "that are given by themselves, beside the vorticity of `initial`"},
                vortices, [&](SingleVortex& vortex) { describe_vortex(d, vortex); });
}

void VortexOptions::check(bool has_walls) const {
  if (overlap && core_size)
    refuse("core.size", "'size' and 'overlap' both say how large cores are");
  if (diffusion != Diffusion::none && kinematic_viscosity == 0)
    refuse("diffusion.type", "nothing diffuses at the viscosity 0: give 'kinematic_viscosity'");
  if (has_walls) refuse_options_beside_walls(*this);
  if (diffusion == Diffusion::none && kinematic_viscosity > 0 && !has_walls)
    refuse("kinematic_viscosity", "the viscosity has no effect without a type of 'diffusion'");
  if (diffusion == Diffusion::core_spreading && core != "gauss")
    refuse("core.name",
           "core_spreading needs the core 'gauss', which stays what it is as it grows");
  if (remeshing == Remeshing::gauss && diffusion != Diffusion::core_spreading)
    refuse("remesh.kernel", "the kernel 'gauss' makes up for core_spreading, and there is none");
}

double VortexOptions::core_radius(double spacing) const {
  if (core == "point") return 0;
  return core_size.value_or(overlap.value_or(1.5) * spacing);
}

std::vector<InitialField> VortexRecipe::initial_fields(int /*dimension*/) const {
  return {{"vorticity", "vorticity of the fluid's particles, each with its cell", "0"}};
}

std::vector<std::string> VortexRecipe::conserved_names(int /*dimension*/) const {
  return {"circulation", "impulse_x", "impulse_y", "angular_impulse"};
}

std::unique_ptr<Model> VortexRecipe::make(SpaceSetup setup) const {
  if (setup.dimension != 2)
    throw InputError("dimension", "the model vortex lives in 2 dimensions, this scenario in 3");
  options.check(std::ranges::any_of(setup.bodies,
                                    [](const Body& body) { return body.kind == BodyKind::wall; }));
  return std::make_unique<Vortex<2>>(options, std::move(setup));
}

}  // namespace mote
