#include "mote/study/study_tables.hpp"

#include <fmt/format.h>

#include <iterator>

#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using Out = std::back_insert_iterator<std::string>;

std::string coordinate_names(int dimension) {
  std::string names;
  for (int d = 0; d < dimension; ++d) names += fmt::format(",{}", axis_names[d]);
  return names;
}

void add_coordinates(Out out, const StudyCase& done, std::size_t i) {
  const auto dimension = static_cast<std::size_t>(done.dimension);
  for (std::size_t d = 0; d < dimension; ++d)
    fmt::format_to(out, ",{:.17g}", done.positions[i * dimension + d]);
}

}  // namespace

std::string study_csv(const StudyResult& result) {
  std::string text = "layout,resolution,operator,quantity,norm,error,order\n";
  for (const StudyRow& row : result.rows)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{:.17g},{}\n", row.layout,
                   row.resolution, row.differential_operator, row.quantity, row.norm, row.error,
                   row.order ? fmt::format("{:.17g}", *row.order) : "");
  return text;
}

CaseTables::CaseTables(const std::filesystem::path& folder, bool with_points)
    : points_{folder / "points.csv", {}},
      check_up_{folder / "check_up.csv", {}},
      with_points_(with_points) {}

void CaseTables::add(const StudyCase& done) {
  if (with_points_ && !done.quantities.empty()) add_points(done);
  if (!done.neighbourhoods.empty()) add_neighbourhoods(done);
}

void CaseTables::write(Table& table, const std::string& header, const std::string& rows) {
  if (!table.file.is_open()) {
    table.file.open(unfinished(table.path), std::ios::binary);
    table.file << header;
  }
  if (!(table.file << rows))
    throw InputError(fmt::format("{}: cannot write this file", table.path.string()));
}

void CaseTables::add_points(const StudyCase& done) {
  std::string header =
      "layout,resolution,operator,index" + coordinate_names(done.dimension) + ",field";
  for (const auto& values : done.quantities)
    for (const auto& ending : values.components)
      header += fmt::format(",{0}{1}_computed,{0}{1}_exact", values.quantity, ending);
  std::string rows;
  const Out out = std::back_inserter(rows);
  for (std::size_t i = 0; i < done.field.size(); ++i) {
    fmt::format_to(out, "{},{},{},{}", done.layout.name, done.resolution,
                   done.differential_operator, i);
    add_coordinates(out, done, i);
    fmt::format_to(out, ",{:.17g}", done.field[i]);
    for (const auto& values : done.quantities)
      for (std::size_t c = 0; c < values.components.size(); ++c) {
        const std::size_t k = i * values.components.size() + c;
        fmt::format_to(out, ",{:.17g},{:.17g}", values.computed[k], values.exact[k]);
      }
    rows += '\n';
  }
  write(points_, header + '\n', rows);
}

void CaseTables::add_neighbourhoods(const StudyCase& done) {
  std::string rows;
  const Out out = std::back_inserter(rows);
  for (std::size_t i = 0; i < done.neighbourhoods.size(); ++i) {
    const auto& [neighbours, covered, condition] = done.neighbourhoods[i];
    fmt::format_to(out, "{},{},{}", done.layout.name, done.differential_operator, i);
    add_coordinates(out, done, i);
    fmt::format_to(out, ",{},{:.17g},{:.17g}\n", neighbours, covered, condition);
  }
  write(check_up_,
        "layout,operator,index" + coordinate_names(done.dimension) +
            ",neighbours,covered,condition\n",
        rows);
}

bool CaseTables::keep_check_up() {
  points_.file.close();
  std::error_code ignored;
  std::filesystem::remove(unfinished(points_.path), ignored);
  const bool has_check_up = check_up_.file.is_open();
  finish(check_up_);
  return has_check_up;
}

void CaseTables::finish() {
  finish(points_);
  finish(check_up_);
}

void CaseTables::finish(Table& table) {
  if (!table.file.is_open()) return;
  table.file.close();
  if (table.file.fail())
    throw InputError(fmt::format("{}: cannot write this file", table.path.string()));
  mote::finish(table.path);
}

}  // namespace mote
