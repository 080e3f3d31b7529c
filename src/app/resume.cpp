#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/run_loop.hpp"
#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

/// The verdict of a run that is complete.
bool passed(const OutputFolder& folder) {
  const auto summary =
      nlohmann::json::parse(read_file(folder.file("summary.json")), nullptr, false);
  return summary.is_object() && summary.value("passed", false);
}

}  // namespace

int resume(const Catalogue& catalogue, const RunOptions& options) {
  OutputFolder folder = OutputFolder::reopen(*options.out);
  RunOptions with_file = options;
  with_file.file = folder.file("run.yaml").string();
  Simulation simulation = prepare_simulation(catalogue, with_file);
  const auto frames = folder.frames();
  if (frames.empty())
    throw InputError(fmt::format("{}: there is no snapshot to go on from; run the scenario again",
                                 *options.out));
  const Snapshot last = folder.read_frame(frames.back());
  try {
    simulation.restore(last);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", folder.snapshot(frames.back()).string(), error.what()));
  }
  if (frames.back() == simulation.plan().frames() && fs::exists(folder.file("summary.json"))) {
    if (!options.quiet) fmt::print("{}: this run is complete\n", *options.out);
    return passed(folder) ? 0 : 1;
  }
  folder.history().resume(last.moment, history_columns(simulation, last.moment.time));
  folder.restore_series();
  return RunLoop(simulation, folder, progress_style(options), last.moment, last.restart).go_on();
}

}  // namespace mote
