#pragma once

#include "mote/app/commands.hpp"
#include "mote/app/progress.hpp"
#include "mote/app/simulation.hpp"

namespace mote {

/// Reads the scenario of a command with its `--set`, sets the number of threads and makes the
/// simulation. Throws LocatedError.
Simulation prepare_simulation(const Catalogue& catalogue, const RunOptions& options);

/// How a command tells its progress.
Progress::Style progress_style(const RunOptions& options);

}  // namespace mote
