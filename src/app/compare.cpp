#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <optional>

#include "mote/app/commands.hpp"
#include "mote/app/member_runs.hpp"
#include "mote/app/one_line.hpp"
#include "mote/app/physical_memory.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/shared_folder.hpp"
#include "mote/compare/compare_report.hpp"
#include "mote/compare/expectations.hpp"
#include "mote/compare/variations.hpp"
#include "mote/output/claim_folder.hpp"
#include "mote/output/files.hpp"
#include "mote/output/folder.hpp"
#include "mote/output/picture.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

constexpr const char* picture_name = "compare.png";

const FolderKind compare_folder{"comparison",
                                "compare.yaml",
                                "# The comparison as it was run.",
                                {"compare.csv", "compare.md", picture_name}};

/// Whether a run was refused because its integrator does not suit it: nothing that is misspelt, but
/// what a comparison of integrators finds out.
bool is_of_the_integrator(const LocatedError& error) {
  return error.key() == "time.integrator" || error.key() == "time.tolerance" ||
         error.key() == "time.dense_output";
}

/// Makes a member as a run would, without running it; notes what the comparison must know of it.
/// Returns the memory that it needs.
double try_member(const Document& document, const Catalogue& catalogue, bool strict,
                  const Comparison& comparison, Member& member) {
  const Simulation simulation(document, read_scenario(document, catalogue), catalogue, strict);
  const Scenario& scenario = simulation.scenario();
  if (comparison.refinement)
    member.spacing = spacing_along(comparison.vary[*comparison.refinement].path, scenario);
  if (simulation.exact() != nullptr)
    member.fields = entry_named(catalogue.exact_solutions, scenario.check.against).fields;
  if (simulation.model().frame() == Frame::eulerian) std::erase(member.fields, "position");
  return simulation.bytes_needed();
}

/// All members, one after the other. Throws LocatedError for the first that cannot be, but for
/// those whose integrator does not suit, if there are others. Returns the memory that the largest
/// needs.
double try_members(const Document& base, const Catalogue& catalogue, bool strict,
                   Comparison& comparison) {
  double largest = 0;
  std::optional<LocatedError> unsuited;
  for (Member& member : comparison.members) {
    const Document document = document_of(base, comparison, member);
    try {
      largest = std::max(largest, try_member(document, catalogue, strict, comparison, member));
    } catch (const LocatedError& error) {
      unsuited = LocatedError(error, fmt::format(" (in the member {})", comparison.label(member)));
      if (!is_of_the_integrator(error)) throw *unsuited;
      member.unsuited = error.message();
    }
  }
  if (std::ranges::all_of(comparison.members, std::not_fn(&Member::suits))) throw *unsuited;
  return largest;
}

/// Shares the threads out among runs beside each other that fit into the memory.
Running running_of(const CompareOptions& options, std::int64_t threads_of_file, std::size_t members,
                   double largest) {
  int threads = options.threads > 0 ? options.threads : static_cast<int>(threads_of_file);
  if (threads == 0) threads = omp_get_max_threads();
  const double fitting = std::floor(0.8 * physical_memory() / std::max(1.0, largest));
  const double possible =
      std::min({static_cast<double>(threads), static_cast<double>(members), fitting});
  const int jobs = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1.0, possible));
  return {static_cast<std::size_t>(jobs), std::max(1, threads / jobs)};
}

/// Whether a name begins as those of members do, with a number.
bool is_of_a_member(const fs::path& path) {
  const std::string name = path.filename().string();
  const auto dash = name.find('-');
  return dash != std::string::npos && dash > 0 &&
         std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(dash),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Removes the runs of a former comparison with their logs, and nothing else.
void remove_former_runs(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / "runs", none))
    if (is_of_a_member(entry.path()) && OutputFolder::is_one(entry.path()))
      paths.push_back(entry.path());
  for (const fs::path& path : paths) {
    OutputFolder::remove(path);
    fs::remove(path.string() + ".log", none);
  }
}

/// Draws the picture; its name, or nothing if there is none.
std::string draw(const fs::path& folder) {
  const std::string problem = draw_pictures(shared_folder() / "plot-compare", folder);
  if (problem.empty()) return picture_name;
  fmt::print(stderr, "mote: warning: no picture: {}\n", one_line(problem));
  return "";
}

void print_outcome(const CompareTable& table, const fs::path& folder, const std::string& picture) {
  fmt::print("\n{}{}", compare_text(table), checks_text(expectation_results(table)));
  if (!picture.empty()) fmt::print("picture: {}\n", (folder / picture).string());
  fmt::print("report:  {}\n", (folder / "compare.md").string());
}

}  // namespace

int compare(const Catalogue& catalogue, const CompareOptions& options) {
  Document document = read_scenario_document(options);
  vary(document, options.variations, options.assignments);
  Scenario scenario = read_scenario(document, catalogue);
  if (scenario.compare.vary.empty())
    throw LocatedError(options.file,
                       "nothing is varied: give --vary key=value,value,... or a section 'compare' "
                       "with a section 'vary'");
  Comparison comparison = comparison_of(scenario.name, scenario.compare);
  const double largest = try_members(document, catalogue, options.strict, comparison);
  check_expectations(comparison, document);

  const fs::path folder = output_folder(options, scenario.name + "-compare");
  const ClaimedFolder claimed(folder, options.overwrite ? Existing::replace : Existing::refuse,
                              compare_folder);
  remove_former_runs(folder);
  claimed.remove_former();
  write_file(folder / compare_folder.mark_file,
             fmt::format("{}\n{}", compare_folder.mark,
                         comparison_yaml(document, resolved_yaml(scenario, catalogue))));
  make_folder(folder / "runs");

  const Running running = running_of(options, scenario.threads, comparison.members.size(), largest);
  CompareTable table(comparison);
  MemberRuns(options, running, folder, table).run_all();
  const std::string picture = scenario.output.picture ? draw(folder) : "";
  write_file(folder / "compare.md", compare_markdown(table, running, picture));
  if (!options.quiet) print_outcome(table, folder, picture);
  const bool holds = std::ranges::all_of(expectation_results(table), &CheckResult::passed);
  return members_passed(table) && holds ? 0 : 1;
}

}  // namespace mote
