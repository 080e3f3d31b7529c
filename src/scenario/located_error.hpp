#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace mote {

/// Bad input with the place where it was written: `file.yaml:12:5: unknown key ...`.
class LocatedError : public std::runtime_error {
 public:
  /// `key` is the dotted path of the key at fault, where it is known.
  LocatedError(const std::string& place, const std::string& message, std::string key = "")
      : std::runtime_error(place + ": " + message), message_(message), key_(std::move(key)) {}

  /// An error with more to say.
  LocatedError(const LocatedError& error, const std::string& more)
      : std::runtime_error(error.what() + more), message_(error.message_), key_(error.key_) {}

  /// What is wrong, without the place.
  const std::string& message() const { return message_; }
  const std::string& key() const { return key_; }

 private:
  std::string message_, key_;
};

}  // namespace mote
