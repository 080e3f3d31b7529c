#pragma once

#include <functional>
#include <string>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// The JSON Schema (2020-12) of a file that `describe_all` describes.
std::string schema_of(const std::string& title,
                      const std::function<void(Description&)>& describe_all);

/// The JSON Schema (2020-12) of a scenario file, from the same descriptions that read it.
std::string scenario_schema(const Catalogue& catalogue);

}  // namespace mote
