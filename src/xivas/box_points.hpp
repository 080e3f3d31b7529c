#pragma once

#include <cstdint>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

/// How the points of a background mesh stand in a box.
struct BoxPoints {
  double spacing = 1;      ///< about: a whole number of spacings fits along every axis
  double jitter = 0;       ///< how far points inside are moved along every axis, in spacings
  std::uint64_t seed = 0;  ///< of the moves
};

/// A lattice that fills a box from side to side, with points inside moved at random; D numbers a
/// point. Those on the sides stay, so that the hull is the box and opposite sides are alike.
template <int D>
std::vector<double> points_in_box(const Vec<D>& lower, const Vec<D>& upper, const BoxPoints& of);

}  // namespace mote
