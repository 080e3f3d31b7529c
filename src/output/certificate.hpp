#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mote/exact/exact_solution.hpp"
#include "mote/models/model.hpp"

namespace mote {

/// Errors of one field against a reference, each relative to the reference's own norm (absolute
/// where that is zero): sum |e|/sum |r|, sqrt(sum e^2/sum r^2), max |e|/max |r|.
struct ErrorNorms {
  std::string field;
  double l1 = 0, l2 = 0, max = 0;
  std::int64_t compared = 0;  ///< points at which the reference has a value

  /// The one in the norm `l1`, `l2` or `max`.
  double in_norm(const std::string& norm) const {
    return norm == "l1" ? l1 : norm == "l2" ? l2 : max;
  }
};

/// Compares values with a reference; points where the reference is NaN are left out and counted.
/// With several components, point by point, |e| and |r| are lengths of vectors.
ErrorNorms error_norms(const std::string& field, std::span<const double> values,
                       std::span<const double> reference, int components = 1);

/// How far a conserved quantity moved, relative to its scale.
struct Drift {
  std::string quantity;
  double start = 0, end = 0, drift = 0;
};
std::vector<Drift> drifts(const std::vector<Conserved>& start, const std::vector<Conserved>& end);

/// One statement of the certificate: a number and the limit it must not exceed, or must reach.
struct CheckResult {
  enum class Sense { at_most, at_least };

  std::string name;
  double value = 0;
  double limit = 0;
  Sense sense = Sense::at_most;
  bool passed() const { return sense == Sense::at_most ? value <= limit : value >= limit; }
};

/// What a run ends with, good or bad.
struct Certificate {
  std::string name, version, units, differential_operator, integrator, model, against;
  std::int64_t dimension = 1, particles = 0, steps = 0;
  int threads = 1;
  double time = 0;
  double wall_seconds = 0;        ///< of this process
  std::int64_t steps_timed = 0;   ///< steps done in wall_seconds
  double bytes_per_particle = 0;  ///< of memory at its peak; 0 on a line, where it says nothing
  PairWork pair_work;
  std::vector<ErrorNorms> errors;
  std::vector<Drift> conservation;
  std::vector<CheckResult> checks;
  std::vector<std::string> remarks, warnings;
  std::optional<std::string> failure;

  bool passed() const;
};

/// The certificate as the contract's summary.json.
std::string summary_json(const Certificate& certificate);

/// Checks as a section of a report, and as lines for a terminal.
std::string checks_markdown(const std::vector<CheckResult>& checks);
std::string checks_text(const std::vector<CheckResult>& checks);

/// The certificate for a person; shows `picture` if there is one.
std::string report_markdown(const Certificate& certificate, const std::string& picture);

}  // namespace mote
