#pragma once

#include <span>

#include "mote/xivas/simplex_mesh.hpp"

namespace mote {

/// A piecewise linear vector field: D numbers at every point of a mesh, which outlives it as the
/// numbers do. Nadukandi 2014, (7)-(12).
template <int D>
class NodalField {
 public:
  NodalField(const SimplexMesh<D>& mesh, std::span<const double> values)
      : mesh_(&mesh), values_(values) {}

  const SimplexMesh<D>& mesh() const { return *mesh_; }

  Vec<D> at_point(Index number) const {
    return Vec<D>::Map(&values_[static_cast<std::size_t>(number) * D]);
  }

  /// The linear field of a cell, there or continued beyond it.
  Vec<D> value(Index cell, const Vec<D>& place) const {
    const MeshCell<D>& of = mesh_->cell(cell);
    Vec<D> sum = Vec<D>::Zero();
    for (std::size_t v = 0; v <= D; ++v)
      sum -= at_point(of.vertices[v]) * (of.faces[v].distance(place) / of.faces[v].height);
    return sum;
  }

  /// Its derivatives by place: row i those of component i. (11)
  Mat<D> gradient(Index cell) const {
    const MeshCell<D>& of = mesh_->cell(cell);
    Mat<D> sum = Mat<D>::Zero();
    for (std::size_t v = 0; v <= D; ++v)
      sum += at_point(of.vertices[v]) * of.faces[v].gradient().transpose();
    return sum;
  }

 private:
  const SimplexMesh<D>* mesh_;
  std::span<const double> values_;
};

}  // namespace mote
