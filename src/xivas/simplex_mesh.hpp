#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "mote/particles/vector.hpp"
#include "mote/xivas/delaunay.hpp"

namespace mote {

/// No cell: what is beyond a face of the hull.
inline constexpr Index no_cell = -1;

/// A face of a cell, the one opposite the vertex of the same place in the cell.
template <int D>
struct MeshFace {
  Vec<D> normal;    ///< outward, of length 1
  Vec<D> point;     ///< a vertex of the face
  double height;    ///< of the cell above the face
  Index neighbour;  ///< the cell beyond, or `no_cell`

  /// How far a place is outside of the face, negative inside. Divided by the height and with the
  /// other sign, the linear shape function of the opposite vertex.
  double distance(const Vec<D>& place) const { return normal.dot(place - point); }

  /// Gradient of that shape function.
  Vec<D> gradient() const { return -normal / height; }
};

template <int D>
struct MeshCell {
  Simplex<D> vertices;
  std::array<MeshFace<D>, D + 1> faces;
};

/// The Delaunay triangulation of points: what carries piecewise linear fields.
template <int D>
class SimplexMesh {
 public:
  static constexpr std::size_t corners = D + 1;

  /// D numbers a point. Throws InputError as `delaunay_cells` does.
  explicit SimplexMesh(std::vector<double> points);

  Index point_count() const { return static_cast<Index>(points_.size()) / D; }
  Index cell_count() const { return static_cast<Index>(cells_.size()); }
  Vec<D> point(Index number) const;
  const MeshCell<D>& cell(Index number) const { return cells_[static_cast<std::size_t>(number)]; }
  double volume(Index cell) const;

  /// The largest coordinate. Distances below the tolerance are rounding of places of that size: a
  /// place so far outside a face may count as inside.
  double extent() const { return extent_; }
  double tolerance() const { return 64 * std::numeric_limits<double>::epsilon() * extent_; }

  /// The cell that a place is in, found by walking from another: through a face that the place is
  /// outside of, again and again, which in a Delaunay triangulation never comes back. `no_cell` for
  /// a place outside the hull.
  Index locate(const Vec<D>& place, Index from = 0) const;

 private:
  void join_faces();

  std::vector<double> points_;
  std::vector<MeshCell<D>> cells_;
  double extent_ = 0;
};

extern template class SimplexMesh<2>;
extern template class SimplexMesh<3>;

}  // namespace mote
