#include "mote/study/report_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace mote {
namespace {

std::string verdict(const std::vector<CheckResult>& checks) {
  if (checks.empty()) return "The study states no check.";
  return std::ranges::all_of(checks, &CheckResult::passed) ? "**Passed: every check holds.**"
                                                           : "**A check failed.**";
}

}  // namespace

std::string markdown_head(const std::vector<std::string>& heads) {
  return fmt::format("| {} |\n|{}\n", fmt::join(heads, " | "),
                     fmt::join(std::vector<std::string>(heads.size(), "---|"), ""));
}

std::string markdown_table(const TableRows& rows) {
  std::string text = markdown_head(rows.front());
  for (std::size_t row = 1; row < rows.size(); ++row)
    fmt::format_to(std::back_inserter(text), "| {} |\n", fmt::join(rows[row], " | "));
  return text;
}

std::string aligned_table(const TableRows& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  std::string text;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{:>{}}{}", row[k], widths[k],
                     k + 1 == row.size() ? "\n" : "  ");
  return text;
}

std::string report_beginning(const std::string& name, const std::string& about,
                             const std::vector<CheckResult>& checks,
                             const std::vector<std::string>& pictures) {
  std::string text =
      fmt::format("# {}\n\n{}\n\n{}\n{}\n", name, verdict(checks), about, checks_markdown(checks));
  for (const std::string& picture : pictures)
    fmt::format_to(std::back_inserter(text), "![{0}]({0})\n\n", picture);
  return text;
}

std::string report_end(const std::string& more) {
  return fmt::format(
      "\nThe study with every default is in `study.yaml`, the numbers are in `study.csv`{}.\n",
      more);
}

}  // namespace mote
