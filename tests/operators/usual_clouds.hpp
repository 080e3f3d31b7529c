#pragma once

#include "support/clouds.hpp"

namespace mote::test {

/// A side at which a cloud has enough points for the reach of the tests, and few enough for sums
/// in long double.
template <int D>
inline constexpr Index usual_side = D == 1 ? 60 : (D == 2 ? 10 : 5);

/// Gives the points circulations, and a vorticity of both signs that is nowhere near 0.
template <int D>
void give_circulation(Points<D>& points, std::uint64_t seed) {
  Draws draws(seed);
  points.circulation = draws.uniform(points.length.size(), -1, 1);
  points.vorticity = draws.uniform(points.length.size(), 0.7, 1.3);
  for (double& vorticity : points.vorticity)
    if (draws.below(2) == 0) vorticity = -vorticity;
}

}  // namespace mote::test
