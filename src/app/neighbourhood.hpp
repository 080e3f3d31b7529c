#pragma once

#include <string>
#include <vector>

#include "mote/particles/cloud.hpp"

namespace mote {

/// Particles and the ones around them with their places, for the message of a failure: the next in
/// number on a line, the nearest in space. Empty for no particles.
std::string neighbourhood(const Cloud& cloud, const std::vector<Index>& particles);

}  // namespace mote
