#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mote/output/certificate.hpp"
#include "mote/scenario/scenario.hpp"

namespace mote {

/// Reads the files that `check.history` names, which lie in `folder` unless their path says another
/// place, and puts their numbers into the document beside the names: the output of a run then
/// stands alone. Throws LocatedError.
void read_reference_curves(Document& document, const std::filesystem::path& folder);

/// Refuses a quantity that is none of the columns. Throws InputError.
void refuse_unknown_quantities(const std::vector<HistoryCheck>& checks,
                               const std::vector<std::string>& columns);

/// The checks of the history, against the file that a run has written.
std::vector<CheckResult> history_results(const Scenario& scenario,
                                         const std::filesystem::path& history);

}  // namespace mote
