#include "mote/app/prepare.hpp"

#include <fmt/format.h>
#include <omp.h>

#include "mote/app/history_checks.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/stationary/stationary_file.hpp"
#include "mote/study/study_file.hpp"

namespace mote {

Document read_document(const RunOptions& options) {
  if (options.file.empty()) throw InputError("the scenario's file must have a name");
  Document document = Document::from_file(options.file);
  for (const std::string& assignment : options.assignments) document.set(assignment);
  read_reference_curves(document, std::filesystem::path(options.file).parent_path());
  return document;
}

Document read_scenario_document(const RunOptions& options) {
  Document document = read_document(options);
  if (is_study(document))
    throw LocatedError(options.file, "this is a study and not a scenario: mote study runs it");
  if (is_stationary(document))
    throw LocatedError(options.file,
                       "this is a model without time: mote run and check take it alone");
  return document;
}

std::filesystem::path output_folder(const RunOptions& options, const std::string& name) {
  namespace fs = std::filesystem;
  if (options.out && options.out->empty()) throw InputError("--out: a folder must have a name");
  if (options.out) return *options.out;
  std::error_code error;
  fs::path folder = fs::path("results") / name;
  for (int k = 2; fs::exists(folder, error); ++k)
    folder = fs::path("results") / fmt::format("{}-{}", name, k);
  return folder;
}

Simulation prepare_simulation(const Catalogue& catalogue, const RunOptions& options) {
  const Document document = read_scenario_document(options);
  Scenario scenario = read_scenario(document, catalogue);
  if (options.threads > 0)
    omp_set_num_threads(options.threads);
  else if (scenario.threads > 0)
    omp_set_num_threads(static_cast<int>(scenario.threads));
  return Simulation(document, std::move(scenario), catalogue, options.strict);
}

Progress::Style progress_style(const RunOptions& options) {
  return options.quiet ? Progress::Style::quiet : Progress::style_of_output();
}

}  // namespace mote
