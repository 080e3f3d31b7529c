#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mote/study/difference_table.hpp"
#include "mote/study/report_parts.hpp"

namespace mote {
namespace {

const ExactColumn& exact_of(const DifferenceTable& table, const DifferenceColumn& column) {
  return *std::ranges::find(table.exact, column.quantity, &ExactColumn::quantity);
}

bool has_one_quantity(const DifferenceTable& table) { return table.exact.size() == 1; }

/// The first sixteen digits, of the eighteen that a long double has; cut off, not rounded.
std::string first_digits(long double value) {
  std::string words = fmt::format("{:.17e}", value);
  if (const auto exponent = words.find('e'); exponent != words.npos) words.erase(exponent - 2, 2);
  return words;
}

/// Digits that agree, of sixteen.
std::string digits(double error) {
  if (!(error < 1)) return "0";
  return fmt::format("{}", error == 0 ? 16 : std::min(16, static_cast<int>(-std::log10(error))));
}

/// Of one quantity the values with their digits, of several the errors alone.
std::vector<std::string> heads(const DifferenceTable& table) {
  std::vector<std::string> heads{"h"};
  if (has_one_quantity(table))
    heads.push_back(fmt::format("exact {}", table.exact.front().quantity));
  for (const DifferenceColumn& column : table.columns)
    heads.push_back(has_one_quantity(table) ? fmt::format("{} (digits)", column.scheme)
                                            : fmt::format("{} {}", column.quantity, column.scheme));
  return heads;
}

std::vector<std::string> cells(const DifferenceTable& table, std::size_t row) {
  std::vector<std::string> cells{fmt::format("{:.0e}", table.h[row])};
  if (has_one_quantity(table)) cells.push_back(first_digits(table.exact.front().values[row]));
  for (const DifferenceColumn& column : table.columns)
    cells.push_back(
        has_one_quantity(table)
            ? fmt::format("{} ({})", first_digits(column.values[row]), digits(column.errors[row]))
            : fmt::format("{:.1e}", column.errors[row]));
  return cells;
}

TableRows rows_of(const DifferenceTable& table) {
  TableRows rows{heads(table)};
  for (std::size_t row = 0; row < table.h.size(); ++row) rows.push_back(cells(table, row));
  return rows;
}

std::string name_of(const DifferenceTable& table, const DifferenceColumn& column) {
  return has_one_quantity(table) ? column.scheme
                                 : fmt::format("{} by {}", column.quantity, column.scheme);
}

}  // namespace

std::vector<CheckResult> table_checks(const DifferenceTableFile& file,
                                      const DifferenceTable& table) {
  std::vector<CheckResult> checks;
  for (const auto& check : file.checks)
    for (const DifferenceColumn& column : table.columns) {
      if (column.scheme != check.scheme) continue;
      if (!check.quantity.empty() && column.quantity != check.quantity) continue;
      const double worst = std::ranges::max(column.errors);
      check.limits.judge(name_of(table, column) + ": largest error", worst, checks);
    }
  return checks;
}

std::string table_csv(const DifferenceTable& table) {
  std::string text = "h,scheme,quantity,value,exact,error\n";
  for (const DifferenceColumn& column : table.columns)
    for (std::size_t row = 0; row < table.h.size(); ++row)
      fmt::format_to(std::back_inserter(text), "{:.17g},{},{},{:.17g},{:.17g},{:.17g}\n",
                     table.h[row], column.scheme, column.quantity, column.values[row],
                     static_cast<double>(exact_of(table, column).values[row]), column.errors[row]);
  return text;
}

std::string table_text(const DifferenceTable& table) { return aligned_table(rows_of(table)); }

std::string table_markdown(const DifferenceTableFile& file, const DifferenceTable& table,
                           const std::vector<std::string>& pictures) {
  const char* about =
      has_one_quantity(table)
          ? "The first 16 digits of values, not rounded, and in brackets how many of them agree "
            "with the exact ones."
          : "Errors of matrices, relative to the exact ones, in the Frobenius norm.";
  return report_beginning(file.name, about, table_checks(file, table), pictures) + "## Table\n\n" +
         markdown_table(rows_of(table)) + report_end();
}

}  // namespace mote
