#pragma once

#include <filesystem>
#include <vector>

#include "mote/models/model.hpp"
#include "mote/output/snapshot.hpp"

namespace mote {

/// history.csv: time, step and named numbers, a row appended at a time. A run that was killed may
/// leave the last row cut short; resuming drops it.
class History {
 public:
  explicit History(std::filesystem::path path) : path_(std::move(path)) {}

  /// Starts the file.
  void begin(const std::vector<Reading>& columns) const;

  /// Keeps the whole rows up to `moment` of a run that goes on from there. Throws InputError if
  /// the file is not the history of such a run.
  void resume(const Moment& moment, const std::vector<Reading>& columns) const;

  void add(const Moment& moment, const std::vector<Reading>& columns) const;

 private:
  std::filesystem::path path_;
};

}  // namespace mote
