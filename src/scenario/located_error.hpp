#pragma once

#include <stdexcept>
#include <string>

namespace mote {

/// Bad input with the place where it was written: `file.yaml:12:5: unknown key ...`.
class LocatedError : public std::runtime_error {
 public:
  LocatedError(const std::string& place, const std::string& message)
      : std::runtime_error(place + ": " + message) {}

  /// An error with more to say.
  LocatedError(const LocatedError& error, const std::string& more)
      : std::runtime_error(error.what() + more) {}
};

}  // namespace mote
