#include "mote/study/study_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mote/particles/failure.hpp"
#include "mote/particles/lattice.hpp"
#include "mote/study/file_points.hpp"
#include "mote/study/line_cells.hpp"

namespace mote {
namespace {

/// Cells at each end that interior norms leave out of `count` along an axis.
std::int64_t margin_of(const PointRequest& request, Index count, char axis) {
  const std::int64_t margin = request.layout.margin.value_or(request.study.margin);
  if (margin > 0 && 2 * margin >= count)
    throw InputError("margin", fmt::format("a margin of {} cells leaves none of {} along {}",
                                           margin, count, axis));
  return margin;
}

/// The points of a mesh of a line: its cells first, then those beyond its lower and upper end, the
/// nearest first.
StudyPoints<1> line_points(const PointRequest& request) {
  const StudyFile& study = request.study;
  const Index count = request.resolution;
  const ExtendedCells cells =
      extended_cells(entry_named(request.catalogue.layouts, request.layout.type),
                     {study.lower[0], study.upper[0], count,
                      static_cast<std::uint64_t>(request.layout.seed.value_or(0)),
                      study.extension.type, request.beyond});
  StudyPoints<1> result{.remarks = cells.remarks};
  const std::int64_t margin = margin_of(request, count, 'x');
  result.points.resize(count + 2 * request.beyond, count);
  auto place = [&, i = 0](Index cell) mutable {
    result.points.position[i] = cells.centre[cell];
    result.points.length[i++] = cells.length[cell];
  };
  for (Index k = 0; k < count; ++k) place(request.beyond + k);
  for (Index k = 0; k < count; ++k)
    result.interior.push_back(k >= margin && count - 1 - k >= margin);
  for (Index k = 1; k <= request.beyond; ++k) place(request.beyond - k);
  for (Index k = 0; k < request.beyond; ++k) place(request.beyond + count + k);
  return result;
}

LatticeExtension lattice_extension(const std::string& type) {
  if (type == "constant") return LatticeExtension::constant;
  if (type == "mirror") return LatticeExtension::mirror;
  if (type == "periodic") return LatticeExtension::periodic;
  return LatticeExtension::formula;
}

/// As many cells along x as the resolution says, and along the others as many as make them square.
template <int D>
StudyPoints<D> lattice(const PointRequest& request) {
  const StudyFile& study = request.study;
  LatticeShape<D> shape{.extension = lattice_extension(study.extension.type)};
  shape.lower = Vec<D>::Map(study.lower.data());
  shape.upper = Vec<D>::Map(study.upper.data());
  const Vec<D> size = shape.upper - shape.lower;
  double total = 1;
  for (int d = 0; d < D; ++d) {
    const double cells = std::max(1.0, std::round(request.resolution * size[d] / size[0]));
    total *= cells + 2 * request.beyond;
    if (total > 1e8)
      throw InputError(
          "resolutions",
          fmt::format("a resolution of {} with {} cells beyond each end makes more than "
                      "1e8 points",
                      request.resolution, request.beyond));
    shape.count[d] = static_cast<Index>(cells);
  }
  if (request.layout.type == "jittered") shape.jitter = request.layout.jitter;
  shape.seed = static_cast<std::uint64_t>(request.layout.seed.value_or(0));
  shape.layers = request.beyond;
  StudyPoints<D> result{.points = lattice_points(shape)};
  std::array<std::int64_t, D> margin;
  for (int d = 0; d < D; ++d) margin[d] = margin_of(request, shape.count[d], "xyz"[d]);
  for (Index i = 0; i < result.points.receivers; ++i) {
    bool interior = true;
    Index cell = i;
    for (int d = 0; d < D; cell /= shape.count[d++]) {
      const Index k = cell % shape.count[d];
      interior = interior && k >= margin[d] && shape.count[d] - 1 - k >= margin[d];
    }
    result.interior.push_back(interior);
  }
  return result;
}

/// Mass and circulation of cells that are their points' volumes.
template <int D>
void fill(Points<D>& points, const ExactField& exact) {
  points.density = exact.density(points.position);
  points.vorticity = exact.vorticity(points.position);
  points.circulation = points.vorticity;
  points.mass = points.density;
  for (Index i = 0; i < points.size(); ++i) {
    double volume = 1;
    for (int d = 0; d < D; ++d) volume *= points.length[i];
    points.mass[i] *= volume;
    points.circulation[i] *= volume;
  }
}

template <int D>
StudyPoints<D> points_of_layout(const PointRequest& request) {
  const auto& lattices = lattice_layouts();
  if (std::ranges::find(lattices, request.layout.type, &Choice::name) != lattices.end())
    return lattice<D>(request);
  if constexpr (D == 1) return line_points(request);
  throw InputError("layouts", "this layout lives on a line");
}

}  // namespace

template <int D>
StudyPoints<D> study_points(const PointRequest& request, const ExactField& exact) {
  if (request.layout.type == "file") return file_points<D>(request, exact);
  StudyPoints<D> result = points_of_layout<D>(request);
  fill(result.points, exact);
  return result;
}

template StudyPoints<1> study_points(const PointRequest&, const ExactField&);
template StudyPoints<2> study_points(const PointRequest&, const ExactField&);
template StudyPoints<3> study_points(const PointRequest&, const ExactField&);

}  // namespace mote
