#include <fmt/format.h>

#include "mote/app/commands.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/run_loop.hpp"
#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

/// `results/<name>`, or the first of `<name>-2`, `<name>-3`, ... that is free.
fs::path new_folder(const std::string& name) {
  std::error_code error;
  fs::path folder = fs::path("results") / name;
  for (int k = 2; fs::exists(folder, error); ++k)
    folder = fs::path("results") / fmt::format("{}-{}", name, k);
  return folder;
}

}  // namespace

int run(const Catalogue& catalogue, const RunOptions& options) {
  Simulation simulation = prepare_simulation(catalogue, options);
  if (options.out && options.out->empty()) throw InputError("--out: a folder must have a name");
  const fs::path path =
      options.out ? fs::path(*options.out) : new_folder(simulation.scenario().name);
  OutputFolder folder =
      OutputFolder::create(path, options.overwrite ? Existing::replace : Existing::refuse);
  write_file(folder.file("run.yaml"),
             fmt::format("{}\n{}", run_file_mark, simulation.resolved_yaml()));
  const Moment start;
  folder.history().begin(simulation.conserved_at_start());
  folder.history().add(start, simulation.conserved_at_start());
  folder.add_snapshot(start, simulation.fingerprint(), simulation.model().cloud());
  return RunLoop(simulation, folder, progress_style(options), start).go_on();
}

}  // namespace mote
