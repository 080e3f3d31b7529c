#pragma once

#include <array>

namespace mote {

/// What a particle gives to the four nodes of a lattice about it along an axis, by Monaghan's
/// (1985) M4': 1 - 5/2 s^2 + 3/2 s^3 up to a distance s = 1, (2 - s)^2 (1 - s)/2 up to 2. The
/// particle is `place`, from 0 to 1 spacings, behind the second of them. Moments up to the second
/// are kept.
inline std::array<double, 4> m4_prime_weights(double place) {
  const auto inner = [](double s) { return 1 - s * s * (2.5 - 1.5 * s); };
  const auto outer = [](double s) { return 0.5 * (2 - s) * (2 - s) * (1 - s); };
  return {outer(1 + place), inner(place), inner(1 - place), outer(2 - place)};
}

}  // namespace mote
