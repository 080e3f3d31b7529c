#pragma once

#include "mote/app/commands.hpp"
#include "mote/scenario/document.hpp"

namespace mote {

/// `mote run` of a model without time: solves it, and writes run.yaml, eigenvalues.csv,
/// wave_functions.csv, summary.json, report.md and a picture. Returns the exit code: 0 every check
/// passed, 1 one failed. Throws LocatedError.
int solve(const Document& document, const RunOptions& options);

}  // namespace mote
