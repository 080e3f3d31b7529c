#pragma once

#include <vector>

#include "mote/models/vortex_options.hpp"
#include "mote/walls/outline.hpp"

namespace mote {

/// The walls of a scenario as outlines, and their numbers among the start's bodies.
struct VortexOutlines {
  std::vector<std::size_t> number;
  std::vector<Outline> outline;
};

/// Throws InputError for walls that vortices cannot have: sides of the domain, shapes without an
/// outline, walls that move or let the fluid slip, bodies less than `least_width` spacings thick or
/// apart.
VortexOutlines vortex_outlines(const SpaceStart& start);

/// Throws InputError for options of the model that have no meaning beside walls, or contradict
/// them.
void refuse_options_beside_walls(const VortexOptions& options);

/// Of bodies and the gaps between them. [spacings]
inline constexpr double least_width = 3;

}  // namespace mote
