#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mote/geometry/combined_shapes.hpp"
#include "mote/particles/body.hpp"

namespace mote {

/// A side of the domain: one end of an axis.
struct Side {
  int axis = 0;
  bool upper = false;
};

/// A wall along a whole side of the domain.
struct SideWall {
  Body body;
  Side side;
};

/// A part of space that a fluid or a wall fills.
struct Region {
  Body body;
  SharedShape whole;
  SharedShape without;  ///< what is left out; null if nothing is
  std::string key;      ///< of the scenario, for messages

  bool holds(const Triple& place, double rounding) const {
    return whole->holds(place, rounding) && !(without && without->holds(place, rounding));
  }
};

/// A domain in two or three dimensions, and what is in it.
struct SpacePlan {
  int dimension = 2;
  Triple lower{}, upper{};  ///< corners of the domain
  std::array<bool, 3> periodic{};
  double spacing = 1;  ///< between particles
  double reach = 0;    ///< of the operator, in spacings
  std::vector<SideWall> walls;
  std::vector<Region> regions;
  double jitter = 0;  ///< how far fluid particles are moved along each axis at most, in spacings
  std::uint64_t seed = 0;
};

}  // namespace mote
