#include "mote/models/vortex_outlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/geometry/polygon.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

constexpr double rounding = 1e-9;

Polygon polygon_of(const std::vector<Triple>& corners) {
  std::vector<double> x, y;
  for (const Triple& corner : corners) {
    x.push_back(corner[0]);
    y.push_back(corner[1]);
  }
  return {std::move(x), std::move(y)};
}

/// Depth of the deepest place near one inside, by steps along the axes that halve where none leads
/// deeper.
double depth_near(const Polygon& polygon, Triple place, double step) {
  double depth = -polygon.distance(place);
  for (const double least = 1e-6 * step; step > least; step /= 2) {
    bool deeper = true;
    while (deeper) {
      deeper = false;
      for (const Triple& way :
           {Triple{step, 0, 0}, Triple{-step, 0, 0}, Triple{0, step, 0}, Triple{0, -step, 0}}) {
        const Triple there{place[0] + way[0], place[1] + way[1], 0};
        const double found = -polygon.distance(there);
        if (found <= depth * (1 + rounding)) continue;
        depth = found;
        place = there;
        deeper = true;
      }
    }
  }
  return depth;
}

/// Diameter of the largest circle in the body, about.
double thickness(const SpaceStart& start, std::size_t body) {
  const auto fluids = static_cast<std::size_t>(
      std::ranges::find_if(start.body,
                           [&](std::int32_t b) {
                             return start.bodies[static_cast<std::size_t>(b)].kind ==
                                    BodyKind::wall;
                           }) -
      start.body.begin());
  std::size_t deepest = start.body.size();
  for (std::size_t i = fluids; i < start.body.size(); ++i) {
    if (static_cast<std::size_t>(start.body[i]) != body) continue;
    if (deepest == start.body.size() ||
        start.wall_places[i - fluids].depth > start.wall_places[deepest - fluids].depth)
      deepest = i;
  }
  const Triple place{start.position[2 * deepest], start.position[2 * deepest + 1], 0};
  return 2 * depth_near(polygon_of(start.bodies[body].outline), place, start.spacing / 2);
}

/// From each of the corners and of the places between them, a spacing apart, of one to the other.
double distance_between(const Body& a, const Body& b, double spacing) {
  const Polygon polygon = polygon_of(b.outline);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < a.outline.size(); ++k) {
    const Triple from = a.outline[k], to = a.outline[(k + 1) % a.outline.size()];
    const double x = to[0] - from[0], y = to[1] - from[1];
    const int parts = 1 + static_cast<int>(std::hypot(x, y) / spacing);
    for (int n = 0; n < parts; ++n) {
      const double share = static_cast<double>(n) / parts;
      least = std::min(least, polygon.distance({from[0] + share * x, from[1] + share * y, 0}));
    }
  }
  return least;
}

void refuse_what_is_no_body(const SpaceStart& start, std::size_t number) {
  const Body& body = start.bodies[number];
  const std::string wall = fmt::format("the wall '{}'", body.name);
  if (start.periodic[0] || start.periodic[1])
    throw InputError("domain.periodic", "bodies in a flow of vortices need an unbounded plane");
  if (body.outline.empty())
    throw InputError("model.type", fmt::format("vortices flow around bodies, each of them one box, "
                                               "ball or polygon, and {} is none",
                                               wall));
  if (body.velocity)
    throw InputError("regions", fmt::format("{} moves, and bodies in a flow of vortices stand "
                                            "still",
                                            wall));
  if (body.slips)
    throw InputError("regions", fmt::format("{} lets the fluid slip, and vortices come from walls "
                                            "where it sticks",
                                            wall));
}

void refuse_narrow(const SpaceStart& start, const VortexOutlines& outlines) {
  const double least = least_width * start.spacing * (1 - 1e-6);
  for (std::size_t a = 0; a < outlines.number.size(); ++a) {
    const Body& body = start.bodies[outlines.number[a]];
    if (const double width = thickness(start, outlines.number[a]); width < least)
      throw InputError("regions", fmt::format("the wall '{}' is {:.3g} spacings thick, and the "
                                              "lattice needs {} at least",
                                              body.name, width / start.spacing, least_width));
    for (std::size_t b = 0; b < a; ++b) {
      const Body& other = start.bodies[outlines.number[b]];
      const double gap = std::min(distance_between(body, other, start.spacing),
                                  distance_between(other, body, start.spacing));
      if (gap < least)
        throw InputError(
            "regions",
            fmt::format("the walls '{}' and '{}' are {:.3g} spacings apart, and the "
                        "lattice needs {} at least",
                        other.name, body.name,
                        std::abs(gap) < rounding * start.spacing ? 0.0 : gap / start.spacing,
                        least_width));
    }
  }
}

}  // namespace

VortexOutlines vortex_outlines(const SpaceStart& start) {
  VortexOutlines result;
  for (std::size_t number = 0; number < start.bodies.size(); ++number) {
    if (start.bodies[number].kind != BodyKind::wall) continue;
    refuse_what_is_no_body(start, number);
    Outline outline;
    for (const Triple& corner : start.bodies[number].outline)
      outline.corners.emplace_back(corner[0], corner[1]);
    result.number.push_back(number);
    result.outline.push_back(std::move(outline));
  }
  refuse_narrow(start, result);
  return result;
}

void refuse_options_beside_walls(const VortexOptions& options) {
  const auto refuse = [](const std::string& key, const std::string& message) {
    throw InputError("model." + key, message);
  };
  if (options.kinematic_viscosity == 0)
    refuse("kinematic_viscosity", "walls where the fluid sticks need a 'kinematic_viscosity'");
  if (options.diffusion != Diffusion::none)
    refuse("diffusion.type",
           "beside walls vorticity spreads between the nodes of their lattice: leave 'diffusion' "
           "out");
  if (options.remesh_every > 0)
    refuse("remesh.every",
           "walls put the vortices on their lattice at the end of every step: leave 'remesh' out");
}

}  // namespace mote
