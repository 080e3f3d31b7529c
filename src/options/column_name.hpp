#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace mote {

/// Whether a name that the user gave can be part of a column's in history.csv: letters, digits and
/// `_`.
inline bool is_column_name(std::string_view name) {
  return !name.empty() &&
         std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

}  // namespace mote
