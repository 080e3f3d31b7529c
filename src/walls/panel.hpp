#pragma once

#include <complex>

namespace mote {

/// A place or a vector in the plane, x + iy.
using Complex = std::complex<double>;

/// A straight piece of a body's surface. Bodies run counter-clockwise, so the fluid is to the
/// right.
struct Panel {
  Complex from, to;

  double length() const { return std::abs(to - from); }
  Complex middle() const { return 0.5 * (from + to); }
  Complex tangent() const { return (to - from) / length(); }
  /// Unit vector into the fluid.
  Complex normal() const { return Complex(0, -1) * tangent(); }
};

/// ln((z - from)/(z - to)); its imaginary part is the angle under which `place` sees the panel,
/// -pi or pi on the panel itself. Far away by a series that is exact to rounding.
/// Half the panel over the distance, squared, up to which the series is taken.
inline constexpr double reach_of_sight_series = 0.1 * 0.1;
Complex sight_of(const Panel& panel, Complex place);

/// Velocity u + iv at a place due to a sheet of unit strength (counter-clockwise circulation per
/// length) on the panel: u - iv = ln((z - from)/(z - to))/(2 pi i t) with the tangent t, the
/// surface integral of Isshiki (2014), (38) with (39c) on a straight piece.
Complex velocity_of_sheet(const Panel& panel, Complex place);

/// Integral of the velocity along `on` due to a vortex of unit circulation at a place: the angle
/// under which the vortex sees the panel over 2 pi. Closed outlines sum to 0 or 1 but for rounding.
double circulation_of_vortex(const Panel& on, Complex place);

/// Integral of the velocity along `on` due to a sheet of unit strength on `of`, another panel that
/// does not cross it, exactly: no quadrature.
double circulation_of_sheet(const Panel& on, const Panel& of);

}  // namespace mote
