#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// Something the user wrote cannot be used (exit code 2). `key` is the dotted path of the scenario
/// key at fault, or empty; whoever holds the file turns it into file, line and column.
class InputError : public std::runtime_error {
 public:
  InputError(std::string key, const std::string& message)
      : std::runtime_error(message), key_(std::move(key)) {}
  explicit InputError(const std::string& message) : InputError("", message) {}

  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// The numerics broke down during a run (exit code 3): what happened first, to which particles,
/// and the likely cause. The run adds step, time and the last good snapshot.
class NumericalFailure : public std::runtime_error {
 public:
  NumericalFailure(const std::string& message, std::vector<Index> particles, std::string cause)
      : std::runtime_error(message), particles_(std::move(particles)), cause_(std::move(cause)) {}

  const std::vector<Index>& particles() const { return particles_; }
  const std::string& cause() const { return cause_; }

 private:
  std::vector<Index> particles_;
  std::string cause_;
};

}  // namespace mote
