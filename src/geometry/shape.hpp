#pragma once

#include <limits>

#include "mote/particles/vector.hpp"

namespace mote {

/// A box with sides along the axes; without an end where a corner is infinite.
struct Extent {
  static constexpr double endless = std::numeric_limits<double>::infinity();

  Triple lower{-endless, -endless, -endless};
  Triple upper{endless, endless, endless};
};

/// A part of space, by the distance of every place from its surface.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Distance from the surface, negative inside. [length]
  virtual double distance(const Triple& place) const = 0;

  /// Whether a place is inside; one on the surface, but for this rounding, is not.
  virtual bool holds(const Triple& place, double rounding) const {
    return distance(place) < -rounding;
  }

  /// A box that the shape lies in.
  virtual Extent extent() const = 0;
};

/// The direction in which the distance grows fastest, as a unit vector, by differences over `step`.
/// Where there is none, as in the middle of a ball, that of a place beside it.
Triple outward_direction(const Shape& shape, const Triple& place, int dimension, double step);

}  // namespace mote
