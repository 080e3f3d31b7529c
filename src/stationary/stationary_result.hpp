#pragma once

#include <string>
#include <vector>

#include "mote/output/certificate.hpp"
#include "mote/stationary/stationary_file.hpp"

namespace mote {

/// The states of a file's equation, beside the exact ones where they are known.
class StationaryResult {
 public:
  /// Throws InputError for a potential without a value, and NumericalFailure where no states come
  /// out.
  explicit StationaryResult(const StationaryFile& file);

  /// Columns `state`, from 1 on, `energy`, and with exact ones `exact` and `relative_error`.
  const Table& energies() const { return energies_; }

  /// Columns `x`, `psi_1`, ..., and with exact ones `exact_1`, ..., from tail to tail.
  Table wave_functions() const;

  /// How the wave functions go on beyond the ends.
  std::string remark() const;

  /// Which states of a problem with tails are not bound: no tail that falls is theirs.
  std::vector<std::string> warnings() const;

  /// The errors of energies against the file's limits.
  std::vector<CheckResult> checks() const;

 private:
  StationaryFile file_;
  SchroedingerProblem problem_;
  StationaryStates states_;
  std::optional<ExactStates> exact_;
  Table energies_;
};

/// The result for a person; shows `picture` if there is one.
std::string stationary_markdown(const Certificate& certificate, const Table& energies,
                                const std::string& picture);

}  // namespace mote
