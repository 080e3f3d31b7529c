#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "mote/compare/compare_table.hpp"

namespace mote {
namespace {

using Words = std::vector<std::string>;

/// A text as a cell, quoted where it must be.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string cell(std::optional<double> number) {
  return number && std::isfinite(*number) ? fmt::format("{:.17g}", *number) : "";
}

Words header(const CompareTable& table) {
  Words names;
  for (const PathValues& varied : table.comparison().vary) names.push_back(cell(varied.path));
  names.insert(names.end(), {"time", "particles", "steps"});
  for (const std::string& field : table.fields())
    for (const Norm& norm : norms) {
      names.push_back(fmt::format("{}_{}", field, norm.name));
      names.push_back(fmt::format("{}_{}_order", field, norm.name));
    }
  names.insert(names.end(), {"evaluations", "wall_seconds", "particle_updates_per_second"});
  for (const std::string& quantity : table.quantities()) names.push_back(quantity + "_drift");
  names.insert(names.end(), {"passed", "failure", "folder"});
  return names;
}

Words cells_of(const CompareTable& table, const Row& row) {
  const Member& member = table.comparison().members[row.member];
  Words cells;
  for (const std::string& value : member.values) cells.push_back(cell(value));
  cells.push_back(row.run ? cell(row.run->time) : "");
  cells.push_back(row.run ? fmt::to_string(row.run->particles) : "");
  cells.push_back(row.run ? fmt::to_string(row.run->steps) : "");
  for (const std::string& field : table.fields())
    for (const Norm& norm : norms) {
      const ErrorNorms* error = row.error(field);
      cells.push_back(error != nullptr ? cell(error->*norm.value) : "");
      cells.push_back(cell(table.order(row, field, norm)));
    }
  cells.push_back(row.run ? fmt::to_string(row.run->pair_work.evaluations) : "");
  cells.push_back(row.run ? cell(row.run->wall_seconds) : "");
  cells.push_back(row.run ? cell(row.updates_per_second) : "");
  for (const std::string& quantity : table.quantities()) cells.push_back(cell(row.drift(quantity)));
  cells.insert(cells.end(),
               {row.passed ? "true" : "false", cell(row.failure()), cell(member.folder)});
  return cells;
}

}  // namespace

std::string compare_csv(const CompareTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(header(table), ","));
  for (const Row& row : table.rows())
    text += fmt::format("{}\n", fmt::join(cells_of(table, row), ","));
  return text;
}

}  // namespace mote
