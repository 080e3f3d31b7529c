#pragma once

#include <filesystem>
#include <string>

namespace mote {

/// Writes a whole file under a temporary name and renames it, so that a reader never meets half a
/// file. Throws InputError if the file cannot be written.
void write_file(const std::filesystem::path& path, const std::string& contents);

/// The temporary name that stands for `path` while it is being written.
std::filesystem::path unfinished(const std::filesystem::path& path);

/// Gives the finished file its name. Throws InputError.
void finish(const std::filesystem::path& path);

/// A whole file as text. Throws InputError if it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace mote
