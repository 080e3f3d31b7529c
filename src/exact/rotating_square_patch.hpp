#pragma once

namespace mote {

/// Pressure at the start in a square patch of fluid, free all around, that turns like a rigid body
/// with the angular velocity omega: p/(rho omega^2 L^2) at the place (x, y) in sides L from a
/// corner. A turning flow has lap p = 2 rho omega^2, and p = 0 at the edges. Besides the double
/// series of Colagrossi (2005),
///   p = -32 sum over odd m, n of sin(m pi x) sin(n pi y)/(pi^4 m n (m^2 + n^2)),
/// there is the single one, which this sums to rounding,
///   p = -x (1 - x) + sum over odd n of 8/(n pi)^3 sin(n pi x) cosh(n pi (y - 1/2))/cosh(n pi/2),
/// and the same with x and y exchanged; terms die out with the distance from the edges in y. The
/// centre has -0.147343. Zero on the edges, NaN outside.
double rotating_square_patch_pressure(double x, double y);

}  // namespace mote
