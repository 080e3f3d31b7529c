#pragma once

#include <string>
#include <vector>

#include "mote/output/certificate.hpp"
#include "mote/study/run_study.hpp"

namespace mote {

/// A cell of a table in print, and what the study finds.
struct MarkedCell {
  std::string differential_operator, layout, quantity;
  double error;
  std::string found, expected;
  std::string because;  ///< why the two differ, where the study file says it
  bool agrees() const { return found == expected; }
};

/// The errors at the highest resolution as marks, beside those that the study file expects.
std::vector<MarkedCell> marked_cells(const StudyFile& study, const StudyResult& result);

/// Every statement of the study's sections `check` and `marks` with its limit.
std::vector<CheckResult> study_checks(const StudyFile& study, const StudyResult& result);

}  // namespace mote
