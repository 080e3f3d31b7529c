#pragma once

#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The steady flows in which the ways of tracers are known, each recognised by their velocities at
/// the start. Throw InputError, with the key `check.against`, for another model or velocity.
std::vector<ExactEntry> tracer_entries();

}  // namespace mote
