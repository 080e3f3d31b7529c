#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/output/certificate.hpp"

namespace mote {

/// What the largest of the errors that a check chooses must hold.
struct ErrorLimits {
  std::optional<double> error;        ///< at most this
  std::optional<double> least_error;  ///< at least this

  void describe(Description& description);

  /// Throws LocatedError, with the place of the check, if nothing is stated or nothing could hold.
  void refuse_senseless(const std::string& place) const;

  void judge(const std::string& name, double largest, std::vector<CheckResult>& checks) const;
};

}  // namespace mote
