#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>

#include "mote/app/commands.hpp"
#include "mote/app/one_line.hpp"
#include "mote/app/prepare.hpp"
#include "mote/app/shared_folder.hpp"
#include "mote/output/claim_folder.hpp"
#include "mote/output/files.hpp"
#include "mote/output/picture.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/study/difference_table.hpp"
#include "mote/study/interpolation_study.hpp"
#include "mote/study/study_file.hpp"
#include "mote/study/study_tables.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> picture_names{"errors.png", "values.png", "check_up.png"};

const FolderKind study_folder{"study",
                              "study.yaml",
                              "# The study as it was run, with every default.",
                              {"study.csv", "study.md", "points.csv", "check_up.csv", "errors.png",
                               "values.png", "check_up.png"}};

/// Draws what there is to draw; the names of the pictures that came out.
std::vector<std::string> draw(const fs::path& folder) {
  const std::string problem = draw_pictures(shared_folder() / "plot-study", folder);
  if (!problem.empty()) fmt::print(stderr, "mote: warning: no picture: {}\n", one_line(problem));
  std::vector<std::string> drawn;
  for (const std::string& name : picture_names)
    if (fs::exists(folder / name)) drawn.push_back(name);
  return drawn;
}

/// The resolved study with the paths of files of points made absolute: its folder is elsewhere.
std::string yaml_for_anywhere(StudyFile& file, const Catalogue& catalogue, const fs::path& beside) {
  for (auto& layout : file.layouts)
    if (!layout.path.empty()) layout.path = (beside / layout.path).lexically_normal().string();
  return resolved_yaml(file, catalogue);
}

/// Writes study.yaml in place of former output.
void begin(const ClaimedFolder& claimed, const fs::path& folder, const std::string& yaml) {
  claimed.remove_former();
  write_file(folder / study_folder.mark_file, fmt::format("{}\n{}", study_folder.mark, yaml));
}

void print_errors(const StudyResult& result) {
  std::size_t layout = 6, name = 8, norm = 4;
  for (const StudyRow& row : result.rows) {
    layout = std::max(layout, row.layout.size());
    name = std::max(name, row.differential_operator.size());
    norm = std::max(norm, row.norm.size());
  }
  fmt::print("{:<{}} {:>10}  {:<{}} {:<11} {:<{}} {:>10} {:>6}\n", "layout", layout, "resolution",
             "operator", name, "quantity", "norm", norm, "error", "order");
  for (const StudyRow& row : result.rows)
    fmt::print("{:<{}} {:>10}  {:<{}} {:<11} {:<{}} {:>10.3e} {:>6}\n", row.layout, layout,
               row.resolution, row.differential_operator, name, row.quantity, row.norm, norm,
               row.error, row.order ? fmt::format("{:.2f}", *row.order) : "");
}

/// A study that needs no points.
template <class File>
int tabulate(File file, const RunOptions& options) {
  const fs::path folder = output_folder(options, file.name);
  const ClaimedFolder claimed(folder, options.overwrite ? Existing::replace : Existing::refuse,
                              study_folder);
  const auto table = evaluated(file);
  begin(claimed, folder, resolved_yaml(file));
  write_file(folder / "study.csv", table_csv(table));
  const auto pictures = file.picture ? draw(folder) : std::vector<std::string>{};
  write_file(folder / "study.md", table_markdown(file, table, pictures));
  const auto checks = table_checks(file, table);
  if (!options.quiet)
    fmt::print("{}{}report:  {}\n", table_text(table), checks_text(checks),
               (folder / "study.md").string());
  return std::ranges::all_of(checks, &CheckResult::passed) ? 0 : 1;
}

}  // namespace

int study(const Catalogue& catalogue, const RunOptions& options) {
  const Document document = read_document(options);
  if (!is_study(document) && document.root().find("model") != nullptr)
    throw LocatedError(options.file, "this is a scenario and not a study: mote run runs it");
  if (options.threads > 0) omp_set_num_threads(options.threads);
  if (is_difference_table(document)) return tabulate(read_difference_table(document), options);
  if (is_interpolation_study(document))
    return tabulate(read_interpolation_study(document), options);
  StudyFile file = read_study(document, catalogue);
  const auto start = std::chrono::steady_clock::now();

  const fs::path folder = output_folder(options, file.name);
  const fs::path beside = fs::absolute(options.file).parent_path();
  ClaimedFolder claimed(folder, options.overwrite ? Existing::replace : Existing::refuse,
                        study_folder);
  CaseTables tables(folder, file.output.points);
  StudyResult result;
  try {
    result = run_study(document, file, catalogue, beside,
                       [&](const StudyCase& done) { tables.add(done); });
  } catch (const LocatedError& error) {
    // What was in the folder is still there, unless the check-up says why the points are bad.
    if (tables.has_check_up()) begin(claimed, folder, yaml_for_anywhere(file, catalogue, beside));
    const bool has_check_up = tables.keep_check_up();
    if (has_check_up && file.output.picture) draw(folder);
    claimed.abandon();
    if (!has_check_up) throw;
    throw LocatedError(error, fmt::format("; the check-up of the points is in {}",
                                          (folder / "check_up.csv").string()));
  }
  begin(claimed, folder, yaml_for_anywhere(file, catalogue, beside));
  tables.finish();
  write_file(folder / "study.csv", study_csv(result));
  const auto pictures = file.output.picture ? draw(folder) : std::vector<std::string>{};
  write_file(folder / "study.md", study_markdown(file, result, pictures));

  const auto checks = study_checks(file, result);
  if (!options.quiet) {
    print_errors(result);
    fmt::print("{}", checks_text(checks));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    fmt::print("{}: {} errors in {:.2g} s\nreport:  {}\n", file.name, result.rows.size(),
               took.count(), (folder / "study.md").string());
  }
  return std::ranges::all_of(checks, &CheckResult::passed) ? 0 : 1;
}

}  // namespace mote
