#pragma once

#include <string>
#include <vector>

#include "mote/scenario/document.hpp"

namespace mote {

/// Puts the `--vary key=v1,v2,...` of a command line into the section `compare` of a scenario file,
/// in place of the file's values of the same key. `assignments` are those of `--set`, which must
/// leave varied keys alone. Throws LocatedError.
void vary(Document& document, const std::vector<std::string>& variations,
          const std::vector<std::string>& assignments);

}  // namespace mote
