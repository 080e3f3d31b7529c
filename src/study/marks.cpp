#include "mote/study/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote {
namespace {

std::string mark_of(double error, const StudyFile::Marks::Threshold& threshold) {
  if (error < threshold.good) return "good";
  return error > threshold.bad ? "bad" : "not_good";
}

std::string reason(const StudyFile::Marks& marks, const MarkedCell& cell) {
  for (const auto& exception : marks.exceptions)
    if (exception.differential_operator == cell.differential_operator &&
        exception.layout == cell.layout && exception.quantity == cell.quantity)
      return exception.because;
  return "";
}

/// What a check says of one row; an order that is not known fails.
void add_checks(const StudyFile::Check& check, const StudyRow& row, bool is_file,
                std::vector<CheckResult>& results) {
  const std::string name = fmt::format("{} of {} on {}, {}", row.quantity,
                                       row.differential_operator, row.layout, row.norm);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr auto at_least = CheckResult::Sense::at_least;
  if (check.error) results.push_back({name + ": error", row.error, *check.error});
  if (is_file) return;  // of one resolution
  if (check.highest_order)
    results.push_back({name + ": order", row.order.value_or(none), *check.highest_order});
  if (check.least_order)
    results.push_back({name + ": order", row.order.value_or(none), *check.least_order, at_least});
}

}  // namespace

std::vector<MarkedCell> marked_cells(const StudyFile& study, const StudyResult& result) {
  std::vector<MarkedCell> cells;
  for (const auto& row : study.marks.expected)
    for (std::size_t k = 0; k < study.layouts.size(); ++k) {
      const StudyRow* measured = result.finest(study.layouts[k].name, row.differential_operator,
                                               row.quantity, study.marks.norm);
      if (measured == nullptr) continue;
      const auto& threshold = *std::ranges::find(study.marks.thresholds, row.quantity,
                                                 &StudyFile::Marks::Threshold::quantity);
      MarkedCell cell{
          row.differential_operator,           study.layouts[k].name, row.quantity, measured->error,
          mark_of(measured->error, threshold), row.marks[k]};
      cell.because = reason(study.marks, cell);
      cells.push_back(std::move(cell));
    }
  return cells;
}

std::vector<CheckResult> study_checks(const StudyFile& study, const StudyResult& result) {
  std::vector<CheckResult> checks;
  for (const auto& check : study.checks)
    for (const auto& layout : study.layouts)
      for (const auto& item : study.operators) {
        if (!check.layout.empty() && check.layout != layout.name) continue;
        if (!check.differential_operator.empty() && check.differential_operator != item.name)
          continue;
        const StudyRow* row = result.finest(layout.name, item.name, check.quantity, check.norm);
        const StudyRow unmeasured{layout.name, 0,
                                  item.name,   check.quantity,
                                  check.norm,  std::numeric_limits<double>::quiet_NaN(),
                                  std::nullopt};
        add_checks(check, row != nullptr ? *row : unmeasured, layout.type == "file", checks);
      }
  const auto cells = marked_cells(study, result);
  const auto agreeing = std::ranges::count_if(cells, &MarkedCell::agrees);
  if (!cells.empty())
    checks.push_back({fmt::format("marks that agree with the {} in print", cells.size()),
                      static_cast<double>(agreeing),
                      static_cast<double>(study.marks.least_agreement),
                      CheckResult::Sense::at_least});
  return checks;
}

}  // namespace mote
