#include <fmt/format.h>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/run_loop.hpp"
#include "mote/output/files.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

/// `results/<name>`, or the first of `<name>-2`, `<name>-3`, ... that is free.
fs::path new_folder(const std::string& name) {
  const fs::path first = fs::path("results") / name;
  if (!fs::exists(first)) return first;
  for (int k = 2;; ++k)
    if (const auto next = fs::path("results") / fmt::format("{}-{}", name, k); !fs::exists(next))
      return next;
}

}  // namespace

int run(const Catalogue& catalogue, const RunOptions& options) {
  Simulation simulation = prepare_simulation(catalogue, options);
  const fs::path path =
      options.out.empty() ? new_folder(simulation.scenario().name) : fs::path(options.out);
  OutputFolder folder =
      OutputFolder::create(path, options.overwrite ? Existing::replace : Existing::refuse);
  write_file(folder.file("run.yaml"), simulation.resolved_yaml());
  const Moment start;
  folder.begin_history(simulation.conserved_at_start());
  folder.add_history(start, simulation.conserved_at_start());
  folder.add_snapshot(start, simulation.fingerprint(), simulation.model().cloud());
  return RunLoop(simulation, folder, progress_style(options)).go_on_from(start);
}

}  // namespace mote
