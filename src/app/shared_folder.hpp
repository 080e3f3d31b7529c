#pragma once

#include <filesystem>

namespace mote {

/// Where the scenarios and the plotting script of mote are: `share/mote` beside the program's
/// folder, or where mote was installed.
std::filesystem::path shared_folder();

}  // namespace mote
