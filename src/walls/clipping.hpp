#pragma once

#include <span>
#include <vector>

#include "mote/walls/panel.hpp"

namespace mote {

/// What a body covers of a square cell.
struct Cover {
  double area = 0;
  Complex moment{};             ///< integral of the place less the middle of the cell over the area
  double right = 0, above = 0;  ///< lengths of the right and the upper side
};

/// The cell with its middle at `middle` and this side, cut by a closed polygon that runs
/// counter-clockwise: exact but for rounding.
Cover cover_of(std::span<const Panel> polygon, Complex middle, double side);

/// The piece of a panel from `from` to `to`, as fractions of its length, inside the cell; empty
/// (from >= to) if there is none.
struct Piece {
  double from = 0, to = 1;
};
Piece piece_inside(const Panel& panel, Complex middle, double side);

}  // namespace mote
