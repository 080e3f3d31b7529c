#pragma once

#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The motions of bodies known in closed form.
std::vector<ExactEntry> bodies_entries();

}  // namespace mote
