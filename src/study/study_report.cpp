#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "mote/study/report_parts.hpp"
#include "mote/study/study_tables.hpp"

namespace mote {
namespace {

using Out = std::back_insert_iterator<std::string>;

std::string words(const std::string& mark) { return mark == "not_good" ? "not good" : mark; }

void add_head(Out out, const std::vector<std::string>& columns) {
  fmt::format_to(out, "{}", markdown_head(columns));
}

/// The errors of one quantity in one norm, a cell for each layout and resolution across, operators
/// down; with several resolutions a layout has a table of its own, with the last order.
void add_errors(Out out, const StudyFile& study, const StudyResult& result,
                const std::function<bool(const StudyRow&)>& chosen, bool several) {
  std::vector<const StudyRow*> rows;
  for (const StudyRow& row : result.rows)
    if (chosen(row)) rows.push_back(&row);
  if (rows.empty()) return;
  std::vector<std::string> head{
      several ? fmt::format("{} on {}, {}", rows.front()->quantity, rows.front()->layout,
                            rows.front()->norm)
              : fmt::format("{}, {}", rows.front()->quantity, rows.front()->norm)};
  for (const StudyRow* row : rows)
    if (row->differential_operator == rows.front()->differential_operator)
      head.push_back(several ? fmt::format("{}", row->resolution)
                             : fmt::format("{}, {}", row->layout, row->resolution));
  if (several) head.push_back("order");
  add_head(out, head);
  for (const auto& item : study.operators) {
    std::string line = fmt::format("| `{}` |", item.name);
    std::optional<double> order;
    for (const StudyRow* row : rows)
      if (row->differential_operator == item.name) {
        line += fmt::format(" {:.3g} |", row->error);
        order = row->order;
      }
    if (several) line += order ? fmt::format(" {:.2f} |", *order) : " – |";
    fmt::format_to(out, "{}\n", line);
  }
  fmt::format_to(out, "\n");
}

void add_all_errors(Out out, const StudyFile& study, const StudyResult& result) {
  const bool several = study.resolutions.size() > 1;
  for (const std::string& quantity : study.quantities)
    for (const std::string& norm : study.norms) {
      const auto of_both = [&](const StudyRow& row) {
        return row.quantity == quantity && row.norm == norm;
      };
      if (!several) add_errors(out, study, result, of_both, several);
      for (const auto& layout : study.layouts)
        if (several)
          add_errors(
              out, study, result,
              [&](const StudyRow& row) { return of_both(row) && row.layout == layout.name; },
              several);
    }
}

void add_marks(Out out, const StudyFile& study, const std::vector<MarkedCell>& cells) {
  if (cells.empty()) return;
  const auto agreeing = std::ranges::count_if(cells, &MarkedCell::agrees);
  fmt::format_to(out,
                 "## Marks\n\n{} of {} marks agree with those in print. Thresholds of the {} "
                 "error:",
                 agreeing, cells.size(), study.marks.norm);
  for (const auto& threshold : study.marks.thresholds)
    fmt::format_to(out, " {} good below {:.3g}, bad above {:.3g};", threshold.quantity,
                   threshold.good, threshold.bad);
  fmt::format_to(out, " where a mark differs, the one in print stands in brackets.\n\n");
  std::vector<std::string> head{"operator", "quantity"};
  for (const auto& layout : study.layouts) head.push_back(layout.name);
  add_head(out, head);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const MarkedCell& cell = cells[k];
    if (k % study.layouts.size() == 0)
      fmt::format_to(out, "| `{}` | {} |", cell.differential_operator, cell.quantity);
    fmt::format_to(out, " {:.2g} {}{} |{}", cell.error, words(cell.found),
                   cell.agrees() ? "" : fmt::format(" **[{}]**", words(cell.expected)),
                   (k + 1) % study.layouts.size() == 0 ? "\n" : "");
  }
  fmt::format_to(out, "\n");
  for (const MarkedCell& cell : cells)
    if (!cell.agrees())
      fmt::format_to(out, "- {} of `{}` on {}: in print {}, here {}. {}\n", cell.quantity,
                     cell.differential_operator, cell.layout, words(cell.expected),
                     words(cell.found),
                     cell.because.empty() ? "No reason is known." : cell.because);
  fmt::format_to(out, "\n");
}

void add_check_ups(Out out, const StudyResult& result) {
  if (result.check_ups.empty()) return;
  fmt::format_to(out,
                 "## Check-up of the points\n\nCovered is the share of the operator's support that "
                 "the volumes of a point and its neighbours fill: about 1 inside, a half at a free "
                 "side. The condition number is that of a parabola's least squares: a few units on "
                 "a lattice, infinite where the neighbours do not fix one. All points are in "
                 "`check_up.csv`.\n\n");
  add_head(out, {"points", "operator", "neighbours, fewest", "least covered", "worst condition",
                 "points without a parabola"});
  for (const CheckUpSummary& s : result.check_ups)
    fmt::format_to(
        out, "| {} | `{}` | {} at {} | {} | {} | {} |\n", s.layout, s.differential_operator,
        s.fewest.value, s.fewest.point,
        std::isfinite(s.least_covered.value)
            ? fmt::format("{:.2f} at {}", s.least_covered.value, s.least_covered.point)
            : "–",
        s.worst_condition.value > 0
            ? fmt::format("{:.3g} at {}", s.worst_condition.value, s.worst_condition.point)
            : "–",
        s.without_parabola);
  fmt::format_to(out, "\n");
}

}  // namespace

std::string study_markdown(const StudyFile& study, const StudyResult& result,
                           const std::vector<std::string>& pictures) {
  std::string text =
      report_beginning(study.name, fmt::format("Field `{}`; units: {}.", study.field, study.units),
                       study_checks(study, result), pictures);
  const Out out = std::back_inserter(text);
  add_marks(out, study, marked_cells(study, result));
  add_check_ups(out, result);
  fmt::format_to(out,
                 "## Errors\n\nOver all points{}, relative to the norm of the exact values; an "
                 "order is that between the two highest resolutions.\n\n",
                 study.dimension > 1 ? " and components" : "");
  add_all_errors(out, study, result);
  if (!result.remarks.empty()) fmt::format_to(out, "## Remarks\n\n");
  for (const std::string& remark : result.remarks) fmt::format_to(out, "- {}\n", remark);
  return text +
         report_end(study.output.points ? ", the values at every point in `points.csv`" : "");
}

}  // namespace mote
