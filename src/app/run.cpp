#include <fmt/format.h>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/run_loop.hpp"
#include "mote/app/solve.hpp"
#include "mote/output/files.hpp"
#include "mote/stationary/stationary_file.hpp"

namespace mote {
int run(const Catalogue& catalogue, const RunOptions& options) {
  const Document document = read_document(options);
  if (is_stationary(document)) return solve(document, options);
  Simulation simulation = prepare_simulation(catalogue, options);
  OutputFolder folder =
      OutputFolder::create(output_folder(options, simulation.scenario().name),
                           options.overwrite ? Existing::replace : Existing::refuse);
  write_file(folder.file("run.yaml"),
             fmt::format("{}\n{}", run_file_mark, simulation.resolved_yaml()));
  const Moment start;
  const auto columns = history_columns(simulation, start.time);
  folder.history().begin(columns);
  folder.history().add(start, columns);
  simulation.model().complete_snapshot();
  folder.add_snapshot(start, simulation.fingerprint(), simulation.model().cloud(),
                      scene_of(simulation.model()));
  return RunLoop(simulation, folder, progress_style(options), start).go_on();
}

}  // namespace mote
