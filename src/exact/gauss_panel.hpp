#pragma once

#include <array>

namespace mote {

/// The Gauss-Legendre rule with 16 points on [-1, 1], exact to degree 31, and what the values of a
/// function there say about it.
struct GaussPanel {
  static constexpr int points = 16;
  using Values = std::array<double, points>;

  Values place;   ///< the points, in order
  Values weight;  ///< of the rule

  /// Entry [k][n] is what the value at place[k] gives to the integral from 0 to place[n] of a
  /// polynomial of degree 15.
  std::array<Values, points> from_middle;

  /// Rows that give the coefficients of the Legendre polynomials of degrees 14 and 15.
  std::array<Values, 2> tail;

  /// The widest gap between neighbouring points, and that between the ends and a point.
  double widest_gap, end_gap;
};

/// Made once.
const GaussPanel& gauss_panel();

}  // namespace mote
