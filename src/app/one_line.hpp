#pragma once

#include <string>

namespace mote {

/// A message as one line of plain text, whatever the words that it quotes: control characters
/// become `\\n`, `\\x1b`, ...
std::string one_line(const std::string& message);

}  // namespace mote
