#include "mote/models/vortex_options.hpp"

#include <algorithm>

#include "mote/models/chosen_sum.hpp"
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

constexpr Word<Stretching> stretchings[] = {
    {Stretching::transposed, "transposed",
     "d alpha/dt = (grad u)^T alpha: what two vortices give each other adds up to nothing"},
    {Stretching::classical, "classical", "d alpha/dt = (alpha . grad) u"}};

void describe_core(Description& d, VortexOptions& options) {
  d.variant(
      {"name", "its form"}, options.core, core_choices("none: a point vortex"),
      [&](const std::string& name) {
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

void describe_ring(Description& d, VortexRing& ring) {
  d.numbers({"centre", "three numbers", true}, ring.centre);
  d.numbers({"normal", "of its plane, which its middle flows along; of any length"}, ring.normal);
  d.number({"radius", "of the circle in the middle of its core", true}, ring.radius, positive);
  d.number({"core",
            "a of its vorticity Gamma/(pi a^2) exp(-(s/a)^2) at the distance s from the circle, in "
            "which the size of gauss cores is included: their 2 size^2 is a part of a^2",
            true},
           ring.core, positive);
  d.number({"circulation", "Gamma", true}, ring.circulation);
}

[[noreturn]] void refuse(const std::string& key, const std::string& message) {
  throw InputError("model." + key, message);
}

}  // namespace

void VortexOptions::describe(Description& d) {
  d.section({"core", "how the circulation of a vortex is spread"},
            [&] { describe_core(d, *this); });
  d.section({"sum", "how velocities are summed in an unbounded fluid"}, [&] {
    d.choice({"method", "which way"}, sum, sum_choices("vortices"));
    d.number({"tolerance", "of the multipole method: error over the largest velocity"}, tolerance,
             {1e-13, 1e-3});
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
  describe_list(
      d,
      {"vortices", "in the plane: that are given by themselves, beside the vorticity of `initial`"},
      vortices, [&](SingleVortex& vortex) { describe_vortex(d, vortex); });
  describe_list(d, {"rings", "in space: vortex rings, beside the vorticity of `initial`"}, rings,
                [&](VortexRing& ring) { describe_ring(d, ring); });
  describe_words(d,
                 {"stretching", "in space: how circulation alpha stretches; default: transposed"},
                 stretching, stretchings);
}

void VortexOptions::check(int dimension, bool has_walls) const {
  if (dimension == 3 && has_walls) throw InputError("regions", "vortices in space know no walls");
  if (dimension == 2 && stretching) refuse("stretching", "in the plane nothing stretches vortices");
  if (dimension == 2 && !rings.empty()) refuse("rings", "vortex rings need 3 dimensions");
  if (dimension == 3 && !vortices.empty())
    refuse("vortices",
           "in space circulation is a vector: give 'rings' or a vorticity in 'initial' in place of "
           "'vortices'");
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

std::vector<InitialField> VortexRecipe::initial_fields(int dimension) const {
  if (dimension == 3)
    return {{"vorticity_x", "vorticity of the fluid's particles, each with its cell", "0"},
            {"vorticity_y", "its component along y", "0"},
            {"vorticity_z", "its component along z", "0"}};
  return {{"vorticity", "vorticity of the fluid's particles, each with its cell", "0"}};
}

std::vector<std::string> VortexRecipe::conserved_names(int dimension) const {
  if (dimension == 3)
    return {"circulation_x",     "circulation_y",     "circulation_z",
            "impulse_x",         "impulse_y",         "impulse_z",
            "angular_impulse_x", "angular_impulse_y", "angular_impulse_z"};
  return {"circulation", "impulse_x", "impulse_y", "angular_impulse"};
}

std::unique_ptr<Model> VortexRecipe::make(SpaceSetup setup) const {
  options.check(setup.dimension, std::ranges::any_of(setup.bodies, [](const Body& body) {
                  return body.kind == BodyKind::wall;
                }));
  if (setup.dimension == 3) return std::make_unique<Vortex<3>>(options, std::move(setup));
  return std::make_unique<Vortex<2>>(options, std::move(setup));
}

}  // namespace mote
