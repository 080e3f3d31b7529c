#pragma once

#include <filesystem>
#include <string>

namespace mote {

/// Draws the pictures of an output folder with a script of mote's shared folder and Debian's
/// Python. Returns what went wrong, or nothing.
std::string draw_pictures(const std::filesystem::path& script, const std::filesystem::path& folder);

}  // namespace mote
