#pragma once

#include <filesystem>
#include <string>

namespace mote {

/// Draws the pictures of an output folder with a script of mote's shared folder and Debian's
/// Python, which is ended after so many seconds, and with this process. Returns what went wrong, or
/// nothing.
std::string draw_pictures(const std::filesystem::path& script, const std::filesystem::path& folder,
                          unsigned seconds = 120);

}  // namespace mote
