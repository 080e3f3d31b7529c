#include "mote/app/solve.hpp"

#include <fmt/format.h>

#include <chrono>

#include "mote/app/one_line.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/shared_folder.hpp"
#include "mote/output/claim_folder.hpp"
#include "mote/output/files.hpp"
#include "mote/output/picture.hpp"
#include "mote/output/tables.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/version.hpp"
#include "mote/stationary/stationary_result.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

const std::string picture_name = "wave_functions.png";

const FolderKind solved_folder{
    "solution",
    "run.yaml",
    "# The model without time as it was solved, with every default.",
    {"eigenvalues.csv", "wave_functions.csv", "summary.json", "report.md", picture_name}};

/// With `strict`, warnings are errors.
StationaryResult result_of(const StationaryFile& file, const Document& document, bool strict) {
  try {
    StationaryResult result(file);
    if (strict && !result.warnings().empty())
      throw InputError("model.states", result.warnings().front() + " (a warning without --strict)");
    return result;
  } catch (const InputError& error) {
    throw LocatedError(document.locate(error.key()), error.what());
  }
}

Certificate certificate_of(const StationaryFile& file, const StationaryResult& result) {
  Certificate certificate{.name = file.name,
                          .version = std::string(version),
                          .units = "hbar^2/2m = 1",
                          .differential_operator = "contevol_1",
                          .integrator = "none",
                          .model = file.type,
                          .against = exact_states_of(file) ? file.potential : "nothing",
                          .dimension = file.dimension,
                          .particles = file.nodes};
  certificate.remarks = {result.remark()};
  for (const std::string& warning : result.warnings())
    certificate.warnings.push_back(file.name + ": warning: " + warning);
  certificate.checks = result.checks();
  return certificate;
}

/// The name of the picture, if it came out; else a warning, which summary.json has too. That is
/// there before, as the picture takes its title from it.
std::string draw(const fs::path& folder, Certificate& certificate) {
  const std::string problem = draw_pictures(shared_folder() / "plot", folder);
  if (problem.empty()) return picture_name;
  certificate.warnings.push_back("no picture: " + problem);
  write_file(folder / "summary.json", summary_json(certificate));
  return "";
}

void print_outcome(const Certificate& certificate, const Table& energies, const fs::path& folder) {
  fmt::print("{}: {} states of {} nodes in {:.2g} s\n", certificate.name, energies[0].values.size(),
             certificate.particles, certificate.wall_seconds);
  fmt::print("{}", checks_text(certificate.checks));
  if (certificate.checks.empty()) fmt::print("  the scenario states no check\n");
  fmt::print("report:  {}\n", (folder / "report.md").string());
}

}  // namespace

int solve(const Document& document, const RunOptions& options) {
  StationaryFile file = read_stationary(document);
  const auto start = std::chrono::steady_clock::now();
  const StationaryResult result = result_of(file, document, options.strict);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const fs::path folder = output_folder(options, file.name);
  const ClaimedFolder claimed(folder, options.overwrite ? Existing::replace : Existing::refuse,
                              solved_folder);
  claimed.remove_former();
  write_file(folder / "run.yaml", fmt::format("{}\n{}", solved_folder.mark, resolved_yaml(file)));
  write_file(folder / "eigenvalues.csv", csv_of(result.energies()));
  write_file(folder / "wave_functions.csv", csv_of(result.wave_functions()));
  Certificate certificate = certificate_of(file, result);
  certificate.wall_seconds = took.count();
  write_file(folder / "summary.json", summary_json(certificate));
  const std::string picture = file.picture ? draw(folder, certificate) : "";
  write_file(folder / "report.md", stationary_markdown(certificate, result.energies(), picture));
  for (const auto& warning : certificate.warnings) fmt::print(stderr, "{}\n", one_line(warning));
  if (!options.quiet) print_outcome(certificate, result.energies(), folder);
  return certificate.passed() ? 0 : 1;
}

}  // namespace mote
