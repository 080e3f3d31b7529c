#include "mote/app/prepare.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

void refuse_what_does_not_fit(const Document& document, const Scenario& scenario) {
  const double needed = bytes_needed(scenario);
  const double there =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed > there)
    throw LocatedError(document.locate("particles.count"),
                       fmt::format("{} particles need about {:.3g} GB, this machine has {:.3g}",
                                   scenario.particles.count, needed / 1e9, there / 1e9));
}

}  // namespace

double bytes_needed(const Scenario& scenario) {
  constexpr double bytes_a_particle = 400;
  return bytes_a_particle * static_cast<double>(scenario.particles.count);
}

Simulation prepare_simulation(const Catalogue& catalogue, const RunOptions& options) {
  if (options.file.empty()) throw InputError("the scenario's file must have a name");
  Document document = Document::from_file(options.file);
  for (const std::string& assignment : options.assignments) document.set(assignment);
  Scenario scenario = read_scenario(document, catalogue);
  refuse_what_does_not_fit(document, scenario);
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
