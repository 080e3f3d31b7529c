#include "mote/models/tracers_options.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>

#include "mote/models/tracers.hpp"
#include "mote/options/column_name.hpp"
#include "mote/particles/failure.hpp"
#include "mote/xivas/box_points.hpp"

namespace mote {
namespace {

constexpr Word<TracerMethod> methods[] = {
    {TracerMethod::streamlines, "streamlines",
     "X-IVAS: exactly along the streamlines of the velocity that is interpolated on a mesh of "
     "simplices, taken at the middle of the step"},
    {TracerMethod::rates, "rates", "by the integrator: dx/dt = u(x, t)"},
};

void describe_mesh(Description& d, TracersOptions::Mesh& mesh) {
  d.section({"mesh", "of streamlines: a Delaunay triangulation of points in the domain"}, [&] {
    d.number({"spacing", "between its points, about; default: that of the tracers"}, mesh.spacing,
             positive);
    d.number({"jitter", "by how many spacings points inside are moved at random"}, mesh.jitter,
             {0, 0.45});
    d.count({"seed", "of those moves"}, mesh.seed, not_negative);
  });
}

template <int D>
double count_of_mesh_points(const TracersOptions::Mesh& mesh, const SpaceStart& domain) {
  const double count =
      count_of_points_in_box<D>(Vec<D>::Map(domain.lower.data()), Vec<D>::Map(domain.upper.data()),
                                mesh.spacing.value_or(domain.spacing));
  if (!is_countable_mesh<D>(count))
    throw InputError("model.mesh.spacing",
                     fmt::format("{:.3g} points are more than a mesh can have", count));
  return count;
}

}  // namespace

void TracersOptions::describe(Description& d) {
  d.expressions({"velocity", "one formula a dimension, in x, y, z and t", true}, velocity);
  describe_words(d, {"method", "how tracers move"}, method, methods);
  if (method == TracerMethod::streamlines || d.wants_all_variants()) describe_mesh(d, mesh);
  describe_list(d,
                {"invariants",
                 "what the exact motion of every tracer keeps; the history has 1 less the largest "
                 "change over the largest "
                 "value"},
                invariants, [&](TracerInvariant& invariant) {
                  d.text({"name", "in the history: <name>_kept", true}, invariant.name);
                  d.expression({"formula", "in x, y, z and r", true}, invariant.formula, "xyzr");
                });
}

void TracersOptions::check() const {
  std::set<std::string> names;
  for (std::size_t k = 0; k < invariants.size(); ++k) {
    const std::string& name = invariants[k].name;
    const std::string key = fmt::format("model.invariants.{}.name", k);
    if (!is_column_name(name))
      throw InputError(
          key, fmt::format("'{}' cannot name an invariant: a name is letters, digits and _", name));
    if (!names.insert(name).second)
      throw InputError(key, fmt::format("there are two invariants '{}'", name));
  }
}

double TracersRecipe::largest_courant_number() const {
  return steps_itself() ? std::numeric_limits<double>::infinity() : 1;
}

/// Measured: 970 bytes a point in the plane, 4700 in space, the most while the triangulation and
/// the cells made of it are both there.
OtherMemory TracersRecipe::other_memory(const SpaceStart& domain) const {
  if (!steps_itself()) return {};
  const bool plane = domain.dimension == 2;
  const double count = plane ? count_of_mesh_points<2>(options.mesh, domain)
                             : count_of_mesh_points<3>(options.mesh, domain);
  return {.key = "model.mesh.spacing",
          .what = fmt::format("a mesh of {:.3g} points", count),
          .bytes = (plane ? 1e3 : 5e3) * count};
}

std::unique_ptr<Model> TracersRecipe::make(SpaceSetup setup) const {
  options.check();
  if (setup.differential_operator)
    throw InputError("operator", "the model tracers forms no derivatives, and knows no operator");
  if (setup.dimension == 2) return std::make_unique<Tracers<2>>(options, std::move(setup));
  return std::make_unique<Tracers<3>>(options, std::move(setup));
}

}  // namespace mote
