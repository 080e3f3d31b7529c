#include "mote/study/interpolation_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "mote/study/report_parts.hpp"

namespace mote {
namespace {

/// The lines of one division of the period: errors of position / velocity, paths across.
TableRows rows_of(const InterpolationTable& table, int sub_intervals) {
  TableRows rows{{"eccentricity"}};
  for (const Choice& path : path_choices()) rows.front().push_back(path.name);
  for (const InterpolationRow& row : table) {
    if (row.sub_intervals != sub_intervals) continue;
    auto& cells = rows.emplace_back(1, fmt::format("{}", row.eccentricity));
    for (const auto& [position, velocity] : row.errors)
      cells.push_back(fmt::format("{:.3e} / {:.3e}", position, velocity));
  }
  return rows;
}

/// A text for each division of the period.
template <class Text>
std::string joined(const InterpolationTable& table, Text text) {
  std::string all;
  for (std::size_t k = 0; k < table.size(); ++k)
    if (k == 0 || table[k].sub_intervals != table[k - 1].sub_intervals)
      all += text(table[k].sub_intervals, rows_of(table, table[k].sub_intervals));
  return all;
}

double error_of(const InterpolationStudy::Check& check, const InterpolationTable& table) {
  const auto row = std::ranges::find_if(table, [&](const InterpolationRow& r) {
    return r.sub_intervals == check.sub_intervals && r.eccentricity == check.eccentricity;
  });
  const Choices paths = path_choices();
  const auto path = std::ranges::find(paths, check.path, &Choice::name) - paths.begin();
  const auto [position, velocity] = row->errors[static_cast<std::size_t>(path)];
  return check.quantity == "position" ? position : velocity;
}

}  // namespace

InterpolationTable evaluated(const InterpolationStudy& study) {
  InterpolationTable table;
  for (const double count : study.sub_intervals)
    for (const double eccentricity : study.eccentricities)
      table.push_back({static_cast<int>(count), eccentricity, {}});
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < table.size(); ++k)
    table[k].errors = kepler_interpolation_errors(table[k].eccentricity, table[k].sub_intervals);
  return table;
}

std::vector<CheckResult> table_checks(const InterpolationStudy& study,
                                      const InterpolationTable& table) {
  std::vector<CheckResult> checks;
  for (const auto& check : study.checks)
    check.limits.judge(fmt::format("{} of {}, e = {}, {} sub-intervals", check.quantity, check.path,
                                   check.eccentricity, check.sub_intervals),
                       error_of(check, table), checks);
  return checks;
}

std::string table_csv(const InterpolationTable& table) {
  const Choices paths = path_choices();
  std::string text = "sub_intervals,eccentricity,path,position,velocity\n";
  for (const InterpolationRow& row : table)
    for (std::size_t k = 0; k < paths.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{},{:.17g},{},{:.17g},{:.17g}\n", row.sub_intervals,
                     row.eccentricity, paths[k].name, row.errors[k].position,
                     row.errors[k].velocity);
  return text;
}

std::string table_text(const InterpolationTable& table) {
  return joined(table, [](int sub_intervals, const TableRows& rows) {
    return fmt::format("{} sub-intervals, errors of position / velocity\n{}", sub_intervals,
                       aligned_table(rows));
  });
}

std::string table_markdown(const InterpolationStudy& study, const InterpolationTable& table,
                           const std::vector<std::string>& pictures) {
  const char* about =
      "Hermite interpolation of the Kepler problem over one period, between exact nodes that "
      "divide "
      "it into equal sub-intervals. Errors are the largest at the tenths of all sub-intervals, of "
      "position / of velocity, in units of the semi-major axis a and of √(μ/a).";
  return report_beginning(study.name, about, table_checks(study, table), pictures) +
         joined(table,
                [](int sub_intervals, const TableRows& rows) {
                  return fmt::format("## {} sub-intervals\n\n{}\n", sub_intervals,
                                     markdown_table(rows));
                }) +
         report_end();
}

}  // namespace mote
