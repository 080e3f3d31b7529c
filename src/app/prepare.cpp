#include "mote/app/prepare.hpp"

#include <omp.h>

#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
Simulation prepare_simulation(const Catalogue& catalogue, const RunOptions& options) {
  if (options.file.empty()) throw InputError("the scenario's file must have a name");
  Document document = Document::from_file(options.file);
  for (const std::string& assignment : options.assignments) document.set(assignment);
  Scenario scenario = read_scenario(document, catalogue);
  if (options.threads > 0)
    omp_set_num_threads(options.threads);
  else if (scenario.threads > 0)
    omp_set_num_threads(static_cast<int>(scenario.threads));
  return Simulation(document, std::move(scenario), catalogue);
}

Progress::Style progress_style(const RunOptions& options) {
  return options.quiet ? Progress::Style::quiet : Progress::style_of_output();
}

}  // namespace mote
