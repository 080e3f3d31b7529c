#pragma once

#include <string>

#include "mote/input/point_table.hpp"

namespace mote::test {

/// What read_points says of a file that it refuses, without the folder of the file.
inline std::string refusal(const std::filesystem::path& path) {
  try {
    read_points(path);
  } catch (const InputError& error) {
    const std::string message = error.what(), folder = path.parent_path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }
  return "read without an error";
}

/// The names of the columns, in order, with commas.
inline std::string names_of(const PointTable& table) {
  std::string names;
  for (const auto& [name, values] : table.columns) names += (names.empty() ? "" : ",") + name;
  return names;
}

}  // namespace mote::test
