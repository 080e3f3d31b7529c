#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// The vertices of a simplex, by number, ascending.
template <int D>
using Simplex = std::array<Index, D + 1>;

/// The cells of the Delaunay triangulation of these points, D numbers each, in lexicographic order:
/// they fill the convex hull. Exact predicates decide, so lattices are no special case. Throws
/// InputError for two points on one place, and for points on one line or, in 3D, one plane.
template <int D>
std::vector<Simplex<D>> delaunay_cells(std::span<const double> points);

}  // namespace mote
