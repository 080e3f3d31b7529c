#include "mote/input/point_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ranges>

namespace mote {
namespace {

using Reader = PointTable (*)(const std::filesystem::path&);

constexpr std::pair<const char*, Reader> readers[] = {
    {".csv", read_csv_points},  {".vtp", read_vtk_points},  {".vtu", read_vtk_points},
    {".vtk", read_vtk_points},  {".hdf", read_hdf5_points}, {".h5", read_hdf5_points},
    {".hdf5", read_hdf5_points}};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& message) {
  throw InputError(path.string() + ": " + message);
}

void check_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) refuse(path, "there is no such file");
  if (std::filesystem::is_directory(path, ignored)) refuse(path, "this is a folder, not a file");
}

Reader reader_of(const std::filesystem::path& path) {
  const auto* found = std::ranges::find(readers, path.extension().string(),
                                        [](const auto& reader) { return reader.first; });
  if (found == std::end(readers))
    refuse(path, fmt::format("a file of points must end in {}",
                             fmt::join(readers | std::views::keys, ", ")));
  return found->second;
}

auto column_of(auto& table, const std::string& name) {
  return std::ranges::find(table.columns, name, [](const auto& column) { return column.first; });
}

std::string names_of(const PointTable& table) {
  return fmt::format("{}", fmt::join(table.columns | std::views::keys, ", "));
}

/// Takes away a coordinate that is zero for all points, and says whether it did.
bool drop_if_zero(PointTable& table, const std::string& coordinate) {
  const auto column = column_of(table, coordinate);
  if (column == table.columns.end()) return false;
  if (!std::ranges::all_of(column->second, [](double value) { return value == 0; })) return false;
  table.columns.erase(column);
  return true;
}

}  // namespace

bool PointTable::has(const std::string& name) const {
  return column_of(*this, name) != columns.end();
}

std::span<const double> PointTable::column(const std::string& name) const {
  const auto found = column_of(*this, name);
  if (found == columns.end())
    throw InputError(fmt::format("there is no column {}; there are: {}", name, names_of(*this)));
  return found->second;
}

PointTable read_points(const std::filesystem::path& path) {
  check_file(path);
  const Reader read = reader_of(path);
  if (!std::ifstream(path).is_open()) refuse(path, "cannot read this file");
  return read(path);
}

std::vector<std::string> coordinate_names(const std::string& array, std::size_t components) {
  if (components < 1 || components > 3)
    throw InputError(
        fmt::format("'{}' has {} numbers a point; a position has 1 to 3", array, components));
  return {axis_names, axis_names + components};
}

std::vector<std::string> component_names(const std::string& field, std::size_t components) {
  if (components == 1) return {field};
  std::vector<std::string> names;
  for (std::size_t c = 0; c < components; ++c)
    names.push_back(field + '_' + (components <= 3 ? axis_names[c] : std::to_string(c)));
  return names;
}

void append(PointTable& table, const std::string& array, const std::vector<std::string>& columns,
            std::span<const double> values) {
  const std::size_t stride = columns.size();
  if (stride == 0) throw InputError(fmt::format("'{}' has no numbers", array));
  const std::size_t rows = values.size() / stride;
  if (!table.columns.empty() && rows != table.rows())
    throw InputError(fmt::format("'{}' has length {}, but {} has length {}", array, rows,
                                 table.columns.front().first, table.rows()));
  for (std::size_t c = 0; c < stride; ++c) {
    if (table.has(columns[c]))
      throw InputError(fmt::format("the column '{}' is there twice", columns[c]));
    std::vector<double>& column = table.columns.emplace_back(columns[c], rows).second;
    for (std::size_t i = 0; i < rows; ++i) column[i] = values[i * stride + c];
  }
}

void drop_zero_coordinates(PointTable& table) {
  if (table.rows() > 0 && drop_if_zero(table, "z")) drop_if_zero(table, "y");
}

void check_coordinates(const PointTable& table) {
  table.column("x");
  if (table.has("z") && !table.has("y")) throw InputError("there is a column z, but no column y");
}

void check_numbers(const PointTable& table) {
  if (table.rows() == 0) throw InputError("there are no points");
  for (const auto& [name, values] : table.columns)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i])) throw InputError(not_finite(name, i, values[i]));
}

std::string not_finite(const std::string& column, std::size_t point, double value) {
  return fmt::format("{} of point {} is {}", column, point,
                     std::isnan(value) ? "not a number" : "infinite");
}

}  // namespace mote
