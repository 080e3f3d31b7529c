#include "mote/xivas/delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <int D>
struct Triangulation;

template <>
struct Triangulation<2>
    : CGAL::Delaunay_triangulation_2<
          Kernel, CGAL::Triangulation_data_structure_2<
                      CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>>> {
  static Point point(const double* x) { return {x[0], x[1]}; }
  auto simplices() const { return finite_face_handles(); }
};

template <>
struct Triangulation<3>
    : CGAL::Delaunay_triangulation_3<
          Kernel, CGAL::Triangulation_data_structure_3<
                      CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>>> {
  static Point point(const double* x) { return {x[0], x[1], x[2]}; }
  auto simplices() const { return finite_cell_handles(); }
};

template <int D>
Triangulation<D> triangulation_of(std::span<const double> points) {
  using Point = typename Triangulation<D>::Point;
  std::vector<std::pair<Point, Index>> numbered;
  for (std::size_t first = 0; first < points.size(); first += D)
    numbered.emplace_back(Triangulation<D>::point(&points[first]), static_cast<Index>(first / D));
  Triangulation<D> triangulation;
  triangulation.insert(numbered.begin(), numbered.end());
  if (triangulation.number_of_vertices() < numbered.size())
    throw InputError("two points of the mesh are on one place");
  if (triangulation.dimension() < D)
    throw InputError(D == 2 ? "all points of the mesh are on one line"
                            : "all points of the mesh are on one plane");
  return triangulation;
}

}  // namespace

template <int D>
std::vector<Simplex<D>> delaunay_cells(std::span<const double> points) {
  const Triangulation<D> triangulation = triangulation_of<D>(points);
  std::vector<Simplex<D>> cells;
  for (const auto& handle : triangulation.simplices()) {
    Simplex<D>& cell = cells.emplace_back();
    for (int v = 0; v <= D; ++v) cell[static_cast<std::size_t>(v)] = handle->vertex(v)->info();
    std::ranges::sort(cell);
  }
  std::ranges::sort(cells);
  return cells;
}

template std::vector<Simplex<2>> delaunay_cells<2>(std::span<const double>);
template std::vector<Simplex<3>> delaunay_cells<3>(std::span<const double>);

}  // namespace mote
