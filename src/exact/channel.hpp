#pragma once

#include <array>

namespace mote {

/// The gap between two parallel plane walls that stand across an axis.
struct Channel {
  int axis = 1;  ///< that the walls are normal to: 0, 1 or 2
  double lower = 0, upper = 1;

  double width() const { return upper - lower; }
  double above_lower(const std::array<double, 3>& place) const {
    return place[static_cast<std::size_t>(axis)] - lower;
  }
};

}  // namespace mote
