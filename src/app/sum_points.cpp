#include "mote/app/sum_points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ranges>

#include "mote/input/point_table.hpp"

namespace mote {
namespace {

using Names = std::vector<std::string>;

bool has_all(const PointTable& table, const Names& names) {
  return std::ranges::all_of(names, [&](const auto& name) { return table.has(name); });
}

/// The ways in which a file can name its strengths, the first preferred.
std::vector<Names> strength_names(SumKernel kernel, int dimension) {
  if (kernel == SumKernel::cauchy) return {{"strength_re", "strength_im"}, {"strength"}};
  if (kernel == SumKernel::gravity) return {{"mass"}, {"strength"}};
  const std::size_t components = dimension == 2 ? 1 : 3;
  return {component_names("circulation", components), component_names("strength", components)};
}

/// The columns side by side.
std::vector<double> rows_of(const PointTable& table, const Names& names) {
  std::vector<double> rows(table.rows() * names.size());
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto column = table.column(names[c]);
    for (std::size_t i = 0; i < column.size(); ++i) rows[i * names.size() + c] = column[i];
  }
  return rows;
}

std::vector<double> strengths(const PointTable& table, SumKernel kernel, int dimension) {
  const auto choices = strength_names(kernel, dimension);
  const auto found =
      std::ranges::find_if(choices, [&](const Names& n) { return has_all(table, n); });
  if (found != choices.end()) return rows_of(table, *found);
  Names wanted;
  for (const Names& names : choices)
    wanted.push_back(
        fmt::format("{}{}", names.size() > 1 ? "columns " : "a column ", fmt::join(names, ", ")));
  throw InputError(fmt::format(
      "{} in {}D needs {}; there are: {}", sum_kernels[static_cast<int>(kernel)], dimension,
      fmt::join(wanted, " or "), fmt::join(table.columns | std::views::keys, ", ")));
}

Names coordinates(int dimension) { return {axis_names, axis_names + dimension}; }

std::vector<double> targets_of(const PointTable& table, int dimension) {
  if (dimension == 2 && table.has("z"))
    throw InputError("there is a column z, but the sources have none");
  return rows_of(table, coordinates(dimension));
}

}  // namespace

SumPoints read_sum_points(SumKernel kernel, const std::filesystem::path& sources,
                          const std::optional<std::string>& targets) {
  SumPoints points{.file = sources.string()};
  const PointTable table = read_points(sources);
  at_place(points.file, [&] {
    points.dimension = table.has("z") ? 3 : 2;
    if (kernel == SumKernel::cauchy && points.dimension == 3)
      throw InputError("there is a column z, but cauchy is a sum in the plane");
    points.position = rows_of(table, coordinates(points.dimension));
    points.strength = strengths(table, kernel, points.dimension);
  });
  if (!targets) return points;
  points.at_sources = false;
  const PointTable places = read_points(*targets);
  points.targets = at_place(*targets, [&] { return targets_of(places, points.dimension); });
  return points;
}

}  // namespace mote
