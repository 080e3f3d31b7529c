#pragma once

#include <filesystem>

#include "mote/app/commands.hpp"
#include "mote/app/progress.hpp"
#include "mote/app/simulation.hpp"

namespace mote {

/// Reads the scenario of a command with its `--set`, sets the number of threads and makes the
/// simulation. Throws LocatedError.
Simulation prepare_simulation(const Catalogue& catalogue, const RunOptions& options);

/// Reads the file of a command with its `--set`. Throws LocatedError.
Document read_document(const RunOptions& options);

/// The same for a command that runs scenarios: refuses a study.
Document read_scenario_document(const RunOptions& options);

/// The folder that `--out` names, or else `results/<name>`, or the first of `<name>-2`, `<name>-3`,
/// ... that is free.
std::filesystem::path output_folder(const RunOptions& options, const std::string& name);

/// How a command tells its progress.
Progress::Style progress_style(const RunOptions& options);

}  // namespace mote
