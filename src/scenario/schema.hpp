#pragma once

#include <string>

#include "mote/catalogue/catalogue.hpp"

namespace mote {

/// The JSON Schema (2020-12) of a scenario file, from the same descriptions that read it.
std::string scenario_schema(const Catalogue& catalogue);

}  // namespace mote
