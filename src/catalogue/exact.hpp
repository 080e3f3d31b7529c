#pragma once

#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The exact solutions of mote, each with how it is made from a model's initial state.
std::vector<ExactEntry> exact_entries();

}  // namespace mote
