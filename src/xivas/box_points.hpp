#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// How the points of a background mesh stand in a box.
struct BoxPoints {
  double spacing = 1;      ///< about: a whole number of spacings fits along every axis
  double jitter = 0;       ///< how far points inside are moved along every axis, in spacings
  std::uint64_t seed = 0;  ///< of the moves
};

/// How many points of about this spacing fill a box, as a number of any size.
template <int D>
double count_of_points_in_box(const Vec<D>& lower, const Vec<D>& upper, double spacing);

/// Whether so many points, and the simplices between them, can be counted by an Index.
template <int D>
bool is_countable_mesh(double points) {
  constexpr double cells_a_point = D == 2 ? 2 : 7;  // of Delaunay: about 6.8 at random places
  return points * std::max<double>(cells_a_point, D) < std::numeric_limits<Index>::max();
}

/// A lattice that fills a box from side to side, with points inside moved at random; D numbers a
/// point. Those on the sides stay, so that the hull is the box and opposite sides are alike. Throws
/// InputError for more than can be counted.
template <int D>
std::vector<double> points_in_box(const Vec<D>& lower, const Vec<D>& upper, const BoxPoints& of);

}  // namespace mote
