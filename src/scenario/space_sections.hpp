#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mote/options/description.hpp"

namespace mote {

/// What a scenario says of a wall, whether it is a side of the domain or a region.
struct WallSection {
  bool slips = false;
  std::vector<std::string> velocity;  ///< one expression in t a dimension; none: it stands still
  bool travels = false;
};

/// A side of the domain that is a wall.
struct SideWallSection : WallSection {
  std::string name;  ///< default: the side
  std::string side;
};

/// A part of space, in the terms of its type.
struct ShapeSection {
  std::string type;
  std::vector<double> lower, upper;  ///< of a box
  std::vector<double> centre;        ///< of a ball
  double radius = 0;
  std::vector<double> x, y;                ///< of a polygon
  std::optional<double> z_lower, z_upper;  ///< where a prism over it ends
  std::string inside;                      ///< positive inside
};

/// A part of space that a fluid or a wall fills.
struct RegionSection : WallSection {
  std::string name, type;
  std::vector<ShapeSection> shapes, except;

  bool is_wall() const { return type == "wall"; }
};

struct NeighboursSection {
  std::string search = "automatic";
  std::optional<double> skin;
};

/// What these sections hold.
void describe_side_walls(Description& description, std::vector<SideWallSection>& walls);
void describe_regions(Description& description, std::vector<RegionSection>& regions);
void describe_neighbours(Description& description, NeighboursSection& neighbours);

/// The side of the domain that has this name: its axis, and whether it is the upper one.
struct SideName {
  int axis;
  bool upper;
};
SideName side_named(const std::string& name);

}  // namespace mote
