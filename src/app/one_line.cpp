#include "mote/app/one_line.hpp"

#include <fmt/format.h>

#include <cctype>

namespace mote {

std::string one_line(const std::string& message) {
  std::string line;
  for (const char c : message) {
    if (c == '\n')
      line += "\\n";
    else if (std::iscntrl(static_cast<unsigned char>(c)) != 0)
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      line += c;
  }
  return line;
}

}  // namespace mote
