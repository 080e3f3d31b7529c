#include "mote/xivas/simplex_mesh.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace mote {
namespace {

/// Gradients of the shape functions of all but the first corner: the rows of the inverse of the
/// matrix of the edges from that corner.
template <int D>
std::array<Vec<D>, D + 1> shape_gradients(const std::array<Vec<D>, D + 1>& corners) {
  Mat<D> edges;
  for (int k = 0; k < D; ++k) edges.col(k) = corners[static_cast<std::size_t>(k + 1)] - corners[0];
  const Mat<D> inverse = edges.inverse();
  std::array<Vec<D>, D + 1> gradients;
  gradients[0] = -inverse.colwise().sum().transpose();
  for (int k = 0; k < D; ++k) gradients[static_cast<std::size_t>(k + 1)] = inverse.row(k);
  return gradients;
}

/// A face by its vertices, to find the two cells that it parts.
template <int D>
struct FaceKey {
  std::array<Index, D> vertices;
  Index cell;
  std::size_t face;

  auto operator<=>(const FaceKey&) const = default;
};

template <int D>
FaceKey<D> key_of(const Simplex<D>& cell, Index number, std::size_t face) {
  FaceKey<D> key{{}, number, face};
  for (std::size_t v = 0, to = 0; v <= D; ++v)
    if (v != face) key.vertices[to++] = cell[v];
  return key;
}

}  // namespace

template <int D>
SimplexMesh<D>::SimplexMesh(std::vector<double> points) : points_(std::move(points)) {
  for (const double x : points_) extent_ = std::max(extent_, std::abs(x));
  for (const Simplex<D>& vertices : delaunay_cells<D>(points_)) {
    MeshCell<D>& cell = cells_.emplace_back();
    cell.vertices = vertices;
    std::array<Vec<D>, corners> places;
    for (std::size_t v = 0; v < corners; ++v) places[v] = point(vertices[v]);
    const auto gradients = shape_gradients<D>(places);
    for (std::size_t v = 0; v < corners; ++v) {
      const double steepness = gradients[v].norm();
      cell.faces[v] = {-gradients[v] / steepness, places[(v + 1) % corners], 1 / steepness,
                       no_cell};
    }
  }
  join_faces();
}

template <int D>
void SimplexMesh<D>::join_faces() {
  std::vector<FaceKey<D>> keys;
  for (Index c = 0; c < cell_count(); ++c)
    for (std::size_t f = 0; f < corners; ++f) keys.push_back(key_of<D>(cell(c).vertices, c, f));
  std::ranges::sort(keys);
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const FaceKey<D>&a = keys[k - 1], &b = keys[k];
    if (a.vertices != b.vertices) continue;
    cells_[static_cast<std::size_t>(a.cell)].faces[a.face].neighbour = b.cell;
    cells_[static_cast<std::size_t>(b.cell)].faces[b.face].neighbour = a.cell;
  }
}

template <int D>
Vec<D> SimplexMesh<D>::point(Index number) const {
  return Vec<D>::Map(&points_[static_cast<std::size_t>(number) * D]);
}

template <int D>
double SimplexMesh<D>::volume(Index number) const {
  const Simplex<D>& vertices = cell(number).vertices;
  Mat<D> edges;
  for (int k = 0; k < D; ++k)
    edges.col(k) = point(vertices[static_cast<std::size_t>(k + 1)]) - point(vertices[0]);
  return std::abs(edges.determinant()) / (D == 2 ? 2 : 6);
}

template <int D>
Index SimplexMesh<D>::locate(const Vec<D>& place, Index from) const {
  for (Index at = from;;) {
    const auto& faces = cell(at).faces;
    const auto beyond = std::ranges::find_if(
        faces, [&](const auto& face) { return face.distance(place) > tolerance(); });
    if (beyond == faces.end() || beyond->neighbour == no_cell)
      return beyond == faces.end() ? at : no_cell;
    at = beyond->neighbour;
  }
}

template class SimplexMesh<2>;
template class SimplexMesh<3>;

}  // namespace mote
