#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mote/scenario/document.hpp"
#include "mote/study/check_up.hpp"
#include "mote/study/study_file.hpp"

namespace mote {

/// A row of study.csv.
struct StudyRow {
  std::string layout;
  std::int64_t resolution;
  std::string differential_operator, quantity, norm;
  double error;                 ///< relative to the exact values' own norm
  std::optional<double> order;  ///< against the resolution before
};

/// What an operator made of one derivative at every point, beside the exact values.
struct QuantityValues {
  std::string quantity;
  std::vector<std::string> components;  ///< endings of the name, one for each number a point
  std::vector<double> computed, exact;
};

/// One operator on one layout at one resolution.
struct StudyCase {
  const StudyFile::Layout& layout;
  std::int64_t resolution;
  std::string differential_operator;
  int dimension;
  std::span<const double> positions;  ///< of the receivers, `dimension` numbers each
  std::span<const double> field;
  std::vector<QuantityValues> quantities;
  std::vector<Neighbourhood> neighbourhoods;  ///< of a user's own points; else empty
};

/// The outcome of a study.
struct StudyResult {
  std::vector<StudyRow> rows;
  std::vector<std::string> remarks;
  std::vector<CheckUpSummary> check_ups;  ///< of a user's own points

  /// The row of a case at the highest resolution; null if it was not measured.
  const StudyRow* finest(const std::string& layout, const std::string& differential_operator,
                         const std::string& quantity, const std::string& norm) const;
};

/// Measures every operator on every layout at every resolution, and shows each case to `visit`:
/// first the neighbourhoods in files of points, without quantities, then what was measured.
/// Files of points are looked for in `folder`. Throws LocatedError.
StudyResult run_study(const Document& document, const StudyFile& study, const Catalogue& catalogue,
                      const std::filesystem::path& folder,
                      const std::function<void(const StudyCase&)>& visit);

}  // namespace mote
