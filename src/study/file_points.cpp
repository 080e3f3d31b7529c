#include "mote/study/file_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mote/input/point_table.hpp"
#include "mote/neighbours/kd_tree.hpp"
#include "mote/operators/kernels/wendland_c2.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// Reads points of D coordinates and nothing else yet.
template <int D>
Points<D> positions_of(const PointTable& table, const std::string& path) {
  int coordinates = 0;
  while (coordinates < 3 && table.has(axis_names[coordinates])) ++coordinates;
  if (coordinates != D)
    throw InputError("layouts", fmt::format("{}: its points have {} coordinate{}, the study has {}",
                                            path, coordinates, coordinates == 1 ? "" : "s", D));
  if (table.rows() > 100'000'000)
    throw InputError("layouts", fmt::format("{}: {} points are too many", path, table.rows()));
  Points<D> points;
  points.resize(static_cast<Index>(table.rows()), static_cast<Index>(table.rows()));
  for (int d = 0; d < D; ++d) {
    const auto column = table.column(axis_names[d]);
    for (std::size_t i = 0; i < column.size(); ++i) points.position[i * D + d] = column[i];
  }
  return points;
}

/// Throws InputError for two points at the same place: no operator can tell them apart.
template <int D>
void refuse_coincident_points(const Points<D>& points, const std::string& path) {
  std::vector<Index> order(static_cast<std::size_t>(points.size()));
  std::iota(order.begin(), order.end(), 0);
  const auto coordinates = [&](Index i) {
    return std::span(points.position).subspan(static_cast<std::size_t>(i) * D, D);
  };
  std::ranges::sort(order, [&](Index a, Index b) {
    const auto x_a = coordinates(a), x_b = coordinates(b);
    if (std::ranges::equal(x_a, x_b)) return a < b;
    return std::ranges::lexicographical_compare(x_a, x_b);
  });
  std::pair<Index, Index> first{points.size(), 0};
  for (std::size_t k = 1; k < order.size(); ++k)
    if (std::ranges::equal(coordinates(order[k - 1]), coordinates(order[k])))
      first = std::min(first, {order[k - 1], order[k]});
  if (first.first < points.size())
    throw InputError("layouts", fmt::format("{}: the points {} and {} lie at the same place", path,
                                            first.first, first.second));
}

/// The table, with its errors told as those of the layout that names it.
PointTable read_table(const std::filesystem::path& path) {
  try {
    return read_points(path);
  } catch (const InputError& error) {
    throw InputError("layouts", error.what());
  }
}

/// The volume of each point from how closely the points lie.
template <int D>
std::vector<double> volumes_by_spacing(const Points<D>& points, const std::string& path) {
  if (points.size() < 2)
    throw InputError("layouts",
                     path + ": a single point has no spacing; give its volume in a column");
  const double width = 2;
  Points<D> measured = points;
  measured.length = KdTreeSearch<D>().mean_distances(points, 2 * D);
  NeighbourLists lists;
  KdTreeSearch<D>().find(measured, {WendlandC2<D>::support(), width, PairLength::gather}, lists);
  std::vector<double> volumes;
  for (Index i = 0; i < points.size(); ++i) {
    const double h = width * measured.length[i];
    double sum = WendlandC2<D>::value(0);
    for (const Index j : lists[i])
      sum += WendlandC2<D>::value((points.at(i) - points.at(j)).norm() / h);
    volumes.push_back(std::pow(h, D) / sum);
  }
  return volumes;
}

void refuse_not_positive(std::span<const double> values, const std::string& path,
                         const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] > 0) || !std::isfinite(values[i]))
      throw InputError("layouts", fmt::format("{}: the {} of point {} must be positive, and is {}",
                                              path, what, i, values[i]));
}

/// Column a over column b.
std::vector<double> quotient(std::span<const double> a, std::span<const double> b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] / b[i]);
  return result;
}

std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

/// Volumes and densities from what the table has, and what the reader should know of it.
template <int D>
std::vector<double> complete_volumes(const PointRequest& request, const ExactField& exact,
                                     const PointTable& table, StudyPoints<D>& result) {
  const bool has_mass = table.has("mass"), has_volume = table.has("volume");
  const bool has_density = table.has("density");
  Points<D>& points = result.points;
  std::vector<double> volume;
  if (has_density)
    points.density = copy(table.column("density"));
  else if (!has_mass || (request.study.states_density && !has_volume))
    points.density = exact.density(points.position);
  if (has_volume) {
    volume = copy(table.column("volume"));
  } else if (has_mass && !points.density.empty()) {
    volume = quotient(table.column("mass"), points.density);
    result.remarks.push_back(request.layout.path + ": volumes are mass over density");
  } else {
    volume = volumes_by_spacing(points, request.layout.path);
    result.remarks.push_back(
        request.layout.path +
        ": volumes follow from how closely the points lie; at a free side they come out up to 1.5 "
        "times too large, in a corner 2.5 times");
  }
  if (points.density.empty()) {
    points.density = quotient(table.column("mass"), volume);
    result.remarks.push_back(request.layout.path + ": densities are mass over volume");
  }
  return volume;
}

/// Throws InputError for points so close to another that they are one to any operator.
template <int D>
void refuse_close_points(const Points<D>& points, const std::string& path) {
  constexpr double closest = 1e-6;
  const std::vector<double> nearest = KdTreeSearch<D>().mean_distances(points, 1);
  for (Index i = 0; i < points.size(); ++i)
    if (points.size() > 1 && nearest[i] < closest * points.length[i])
      throw InputError("layouts",
                       fmt::format("{}: point {} lies {:.2g} beside another, less than {} of the "
                                   "spacing there",
                                   path, i, nearest[i], closest));
}

}  // namespace

template <int D>
StudyPoints<D> file_points(const PointRequest& request, const ExactField& exact) {
  const std::filesystem::path path = request.folder / request.layout.path;
  const PointTable table = read_table(path);
  StudyPoints<D> result{.points = positions_of<D>(table, path.string())};
  Points<D>& points = result.points;
  refuse_coincident_points(points, path.string());
  for (const char* column : {"mass", "volume", "density"})
    if (table.has(column)) refuse_not_positive(table.column(column), path.string(), column);
  points.density.clear();
  const std::vector<double> volume = complete_volumes(request, exact, table, result);
  refuse_not_positive(volume, path.string(), "volume");
  points.vorticity = exact.vorticity(points.position);
  points.circulation = points.vorticity;
  points.mass = points.density;
  for (Index i = 0; i < points.size(); ++i) {
    points.length[i] = std::pow(volume[i], 1.0 / D);
    points.circulation[i] *= volume[i];
    points.mass[i] *= volume[i];
  }
  if (table.has("mass")) points.mass = copy(table.column("mass"));
  refuse_close_points(points, path.string());
  if (table.has("field")) {
    result.field = copy(table.column("field"));
    result.remarks.push_back(request.layout.path +
                             ": the field's values are the file's own column");
  }
  return result;
}

template StudyPoints<1> file_points(const PointRequest&, const ExactField&);
template StudyPoints<2> file_points(const PointRequest&, const ExactField&);
template StudyPoints<3> file_points(const PointRequest&, const ExactField&);

}  // namespace mote
