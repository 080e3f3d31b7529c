#pragma once

#include <filesystem>
#include <string>

namespace mote {

/// Draws `fields.png` in an output folder with the script `plot` of mote's shared folder and
/// Debian's Python. Returns what went wrong, or nothing.
std::string draw_picture(const std::filesystem::path& shared, const std::filesystem::path& folder);

}  // namespace mote
