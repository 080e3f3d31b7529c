#include "mote/models/tracers_options.hpp"

#include <fmt/format.h>

#include <set>

#include "mote/models/tracers.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

constexpr Word<TracerMethod> methods[] = {
    {TracerMethod::streamlines, "streamlines",
     "X-IVAS: exactly along the streamlines of the velocity that is interpolated on a mesh of "
     "simplices, taken at the middle of the step"},
    {TracerMethod::rates, "rates", "by the integrator: dx/dt = u(x, t)"},
};

}  // namespace

void TracersOptions::describe(Description& d) {
  d.expressions({"velocity", "one formula a dimension, in x, y, z and t", true}, velocity);
  describe_words(d, {"method", "how tracers move"}, method, methods);
  d.section({"mesh", "of streamlines: a Delaunay triangulation of points in the domain"}, [&] {
    d.number({"spacing", "between its points, about; default: that of the tracers"}, mesh.spacing,
             positive);
    d.number({"jitter", "by how many spacings points inside are moved at random"}, mesh.jitter,
             {0, 0.45});
    d.count({"seed", "of those moves"}, mesh.seed, not_negative);
  });
  describe_list(d,
                {"invariants",
                 "what the exact motion of every tracer keeps; the history has 1 less the largest "
                 "change over the largest "
                 "value"},
                invariants, [&](TracerInvariant& invariant) {
                  d.text({"name", "in the history: <name>_kept", true}, invariant.name);
                  d.expression({"formula", "in x, y and z", true}, invariant.formula);
                });
}

void TracersOptions::check() const {
  std::set<std::string> names;
  for (std::size_t k = 0; k < invariants.size(); ++k)
    if (!names.insert(invariants[k].name).second)
      throw InputError(fmt::format("model.invariants.{}.name", k),
                       fmt::format("there are two invariants '{}'", invariants[k].name));
}

std::unique_ptr<Model> TracersRecipe::make(SpaceSetup setup) const {
  options.check();
  if (setup.dimension == 2) return std::make_unique<Tracers<2>>(options, std::move(setup));
  return std::make_unique<Tracers<3>>(options, std::move(setup));
}

}  // namespace mote
