#pragma once

#include <vector>

#include "mote/particles/vector.hpp"
#include "mote/walls/panel.hpp"

namespace mote {

/// The surface of a body in the plane: corners, joined by straight sides, the last to the first.
struct Outline {
  std::vector<Complex> corners;
};

/// A regular polygon of as many sides, of the area of the circle; its first corner is at angle 0.
Outline circle_outline(Complex centre, double radius, Index sides);

/// Twice the area of a polygon is the sum of cross products; positive counter-clockwise.
double area_of(const Outline& outline);

/// The sides cut into panels of equal length, the longest that is not above `length`; corners stay
/// ends of panels, counter-clockwise whichever way the corners run. Throws InputError if the
/// corners are no polygon.
std::vector<Panel> panels_of(const Outline& outline, double length);

}  // namespace mote
