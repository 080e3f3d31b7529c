#include <fmt/format.h>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/run_loop.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

int resume(const Catalogue& catalogue, const RunOptions& options) {
  OutputFolder folder = OutputFolder::open(*options.out);
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
  folder.resume_history(last.moment, simulation.conserved_at_start());
  folder.note_snapshot(last.moment);
  return RunLoop(simulation, folder, progress_style(options)).go_on_from(last.moment);
}

}  // namespace mote
