#include "mote/scenario/folder_name.hpp"

#include <fmt/format.h>

namespace mote {

std::string folder_name_problem(const std::string& name) {
  constexpr const char* characters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  if (name.find_first_not_of(characters) != std::string::npos || name.starts_with('.'))
    return fmt::format("'{}' cannot name a folder: letters, digits, '_', '-' and '.' can", name);
  if (name.size() > 100)
    return fmt::format("a name has at most 100 characters, and this has {}", name.size());
  return "";
}

}  // namespace mote
