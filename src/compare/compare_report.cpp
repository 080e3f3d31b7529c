#include "mote/compare/compare_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "mote/compare/expectations.hpp"

namespace mote {
namespace {

using Words = std::vector<std::string>;

constexpr const char* no_value = "–";

/// A failure without its step and time, and without what follows its first sentence.
std::string reason(const std::string& failure) {
  const auto start = failure.starts_with("step ") ? failure.find(": ") + 2 : 0;
  return failure.substr(start, failure.find(". Likely cause", start) - start);
}

std::string cell(std::optional<double> number, const char* format) {
  return number && std::isfinite(*number) ? fmt::format(fmt::runtime(format), *number) : no_value;
}

std::string order_cell(std::optional<double> order) {
  const std::string text = cell(order, "{:.2f}");
  return text == "-0.00" ? "0.00" : text;
}

/// Conserved quantities with the components of a vector as one: `momentum` of `momentum_x`, ...
Words vectors_of(const Words& quantities) {
  Words names;
  for (const std::string& quantity : quantities) {
    const bool is_component =
        quantity.ends_with("_x") || quantity.ends_with("_y") || quantity.ends_with("_z");
    const std::string name = quantity.substr(0, quantity.size() - (is_component ? 2 : 0));
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

/// The drift of a quantity, or the one of its components that is furthest from 0.
std::optional<double> drift_of(const Row& row, const std::string& vector) {
  std::optional<double> furthest;
  for (const char* component : {"", "_x", "_y", "_z"})
    if (const auto drift = row.drift(vector + component);
        drift && !(furthest && std::abs(*drift) <= std::abs(*furthest)))
      furthest = drift;
  return furthest;
}

Words header(const CompareTable& table) {
  const Comparison& comparison = table.comparison();
  Words names;
  for (const PathValues& varied : comparison.vary) names.push_back(varied.path);
  for (const std::string& field : table.fields()) {
    names.push_back(field + " L2");
    if (comparison.refinement) names.emplace_back("order");
  }
  if (table.counts_evaluations()) names.insert(names.end(), {"steps", "evaluations"});
  names.emplace_back("wall s");
  for (const std::string& quantity : vectors_of(table.quantities()))
    names.push_back(quantity + " drift");
  names.emplace_back("verdict");
  return names;
}

/// All cells of a row but the verdict.
Words cells_of(const CompareTable& table, const Row& row) {
  const Comparison& comparison = table.comparison();
  const Norm& l2 = norm_named("l2");
  Words cells = comparison.members[row.member].values;
  for (const std::string& field : table.fields()) {
    const ErrorNorms* error = row.error(field);
    cells.push_back(cell(error != nullptr ? std::optional(error->l2) : std::nullopt, "{:.2e}"));
    if (comparison.refinement) cells.push_back(order_cell(table.order(row, field, l2)));
  }
  if (table.counts_evaluations()) {
    cells.push_back(row.run ? fmt::to_string(row.run->steps) : no_value);
    cells.push_back(row.run ? fmt::to_string(row.run->pair_work.evaluations) : no_value);
  }
  cells.push_back(row.run ? cell(row.run->wall_seconds, "{:.2g}") : no_value);
  for (const std::string& quantity : vectors_of(table.quantities()))
    cells.push_back(cell(drift_of(row, quantity), "{:.1e}"));
  return cells;
}

std::string marked(const std::string& text, const char* mark) {
  return fmt::format("{0}{1}{0}", mark, text);
}

/// A text in a cell of a table, whose columns `|` would part.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string markdown_row(const CompareTable& table, const Row& row) {
  Words cells = cells_of(table, row);
  for (std::size_t k = 0; k < table.comparison().vary.size(); ++k)
    cells[k] = marked(escaped(cells[k]), "`");
  const bool ran = row.run && !row.broke_down();
  cells.push_back(ran ? verdict(row) : marked(escaped(verdict(row)), "**"));
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_table(const CompareTable& table) {
  const Words names = header(table);
  std::string text = fmt::format("| {} |\n|{}\n", fmt::join(names, " | "),
                                 fmt::join(Words(names.size(), "---|"), ""));
  for (const Row& row : table.rows()) text += markdown_row(table, row);
  return text;
}

std::string what_was_varied(const Comparison& comparison) {
  Words keys;
  for (const PathValues& varied : comparison.vary)
    keys.push_back(fmt::format("`{}` over {} value{}", varied.path, varied.values.size(),
                               varied.values.size() == 1 ? "" : "s"));
  return fmt::format("{} run{} of one scenario, with {}.", comparison.members.size(),
                     comparison.members.size() == 1 ? "" : "s", fmt::join(keys, " and "));
}

std::string outcome(const CompareTable& table, const std::vector<CheckResult>& checks) {
  const auto unforeseen = std::ranges::count_if(table.rows(), [&](const Row& row) {
    const Member& member = table.comparison().members[row.member];
    return !row.passed && !must_fail(table.comparison(), member);
  });
  const auto broken = std::ranges::count_if(checks, std::not_fn(&CheckResult::passed));
  std::string text =
      unforeseen == 0
          ? "**Every run that should reach its end did, and holds the checks that it states.**"
          : fmt::format("**{} of {} runs did not pass.**", unforeseen, table.rows().size());
  if (!checks.empty())
    text += broken == 0
                ? " **Every expectation holds.**"
                : fmt::format(" **{} of {} expectations do not hold.**", broken, checks.size());
  return text;
}

std::string how_it_ran(const Running& running) {
  const std::string threads =
      fmt::format("on {} thread{} each.", running.threads, running.threads == 1 ? "" : "s");
  if (running.jobs == 1)
    return fmt::format("The runs were made one after the other, {}\n", threads);
  return fmt::format(
      "Up to {} runs were made beside each other, {} They share memory and caches: `--jobs 1` "
      "gives clean times.\n",
      running.jobs, threads);
}

/// What the runs were compared with.
Words references(const CompareTable& table) {
  Words names;
  for (const Row& row : table.rows())
    if (row.run && !row.run->errors.empty() &&
        std::ranges::find(names, row.run->against) == names.end())
      names.push_back(row.run->against);
  return names;
}

/// What the columns of the table are.
std::string legend(const CompareTable& table) {
  std::string text;
  if (!table.fields().empty())
    text += fmt::format("Errors are relative L2 errors at the end against `{}`. ",
                        fmt::join(references(table), "`, `"));
  if (const auto refined = table.comparison().refinement)
    text += fmt::format("An order is that from the next coarser `{}`. ",
                        table.comparison().vary[*refined].path);
  if (table.counts_evaluations())
    text += "Evaluations are the times that sums over pairs were formed. ";
  return text +
         "A drift is the change of a conserved quantity relative to its size, of a vector that of "
         "the component that changes most.\n";
}

/// Characters on a terminal, not bytes.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to) {
  return text + std::string(to - std::min(to, width(text)), ' ');
}

}  // namespace

std::string verdict(const Row& row) {
  if (row.broke_down())
    return fmt::format("failed at t = {:.6g}: {}", row.run->time, reason(*row.run->failure));
  if (!row.run) return "no result: " + row.problem;
  if (row.passed) return row.is_checked ? "passed" : "ran";
  return fmt::format("check failed: {}", fmt::join(row.failed_checks, ", "));
}

std::string compare_markdown(const CompareTable& table, const Running& running,
                             const std::string& picture) {
  const Comparison& comparison = table.comparison();
  const auto checks = expectation_results(table);
  std::string text = fmt::format("# {}: a comparison\n\n{} {}\n", comparison.name,
                                 what_was_varied(comparison), outcome(table, checks));
  if (!picture.empty()) text += fmt::format("\n![the members compared]({})\n", picture);
  text += fmt::format("\n{}\n{}", legend(table), markdown_table(table));
  text += checks_markdown(checks);
  text += fmt::format("\n## Cost\n\n{}", how_it_ran(running));
  text += "The seconds are those of the steps; exact solutions come on top of them.\n";
  text +=
      "\nEvery run has its own folder in `runs/`, with a report; all numbers are in `compare.csv`."
      "\n`mote compare compare.yaml` makes the same comparison again.\n";
  return text;
}

std::string compare_text(const CompareTable& table) {
  std::vector<Words> lines{header(table)};
  for (const Row& row : table.rows()) {
    lines.push_back(cells_of(table, row));
    lines.back().push_back(verdict(row));
  }
  std::string text;
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const Words& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], width(line[k]));
  for (const Words& line : lines) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) text += padded(line[k], widths[k]) + "  ";
    text += line.back() + "\n";
  }
  return text;
}

}  // namespace mote
