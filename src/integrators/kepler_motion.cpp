#include "mote/integrators/kepler_motion.hpp"

#include <cmath>
#include <numbers>

namespace mote {
namespace {

[[gnu::always_inline]] inline Pack dot(const PackVector& x, const PackVector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// G_n = X^n c_n(beta X^2), with the functions c_n of Stumpff.
struct Universal {
  Pack g0, g1, g2, g3;
};

/// c_2 and c_3 up to |z| = 0.1, by their series.
struct Stumpff {
  Pack c2, c3;
};

[[gnu::always_inline]] inline Stumpff series(const Pack& z) {
  // c_n(z) = sum_k (-z)^k/(n + 2 k)!
  constexpr std::array<double, 8> c2{
      1.0 / 2,       -1.0 / 24,        1.0 / 720,         -1.0 / 40320,
      1.0 / 3628800, -1.0 / 479001600, 1.0 / 87178291200, -1.0 / 20922789888000};
  constexpr std::array<double, 8> c3{
      1.0 / 6,        -1.0 / 120,        1.0 / 5040,          -1.0 / 362880,
      1.0 / 39916800, -1.0 / 6227020800, 1.0 / 1307674368000, -1.0 / 355687428096000};
  Pack two = Pack{} + c2[7], three = Pack{} + c3[7];
  for (std::size_t k = 7; k-- > 0;) {
    two = two * z + c2[k];
    three = three * z + c3[k];
  }
  return {two, three};
}

/// Arguments are quartered until the series converge, all alike, and then
///   c_2(4 z) = c_1^2/2,   c_3(4 z) = (c_2 + c_0 c_3)/4,   c_1 = 1 - z c_3,   c_0 = 1 - z c_2.
[[gnu::always_inline]] inline Universal universal(const Pack& beta, const Pack& x) {
  Pack z = beta * x * x;
  int quarterings = 0;
  for (double largest = largest_of(magnitude(z)); largest > 0.1 && quarterings < 20; largest /= 4) {
    z /= 4;
    ++quarterings;
  }
  Stumpff c = series(z);
  for (; quarterings > 0; --quarterings) {
    const Pack c0 = 1 - z * c.c2, c1 = 1 - z * c.c3;
    c = {c1 * c1 / 2, (c.c2 + c0 * c.c3) / 4};
    z *= 4;
  }
  const Pack g2 = x * x * c.c2, g3 = x * x * x * c.c3;
  return {1 - beta * g2, x - beta * g3, g2, g3};
}

/// An orbit as Kepler's equation sees it:
///   F(X) = r_0 X + eta G_2 + zeta G_3 - t = 0,   eta = x v,   zeta = pull - beta r_0.
struct Orbit {
  Pack distance, beta, eta, zeta, time;

  [[gnu::always_inline]] Pack excess(const Pack& x, const Universal& u) const {
    return distance * x + eta * u.g2 + zeta * u.g3 - time;
  }
  [[gnu::always_inline]] Pack distance_at(const Universal& u) const {
    return distance + eta * u.g1 + zeta * u.g2;
  }
  [[gnu::always_inline]] Pack slope_at(const Universal& u) const {
    return eta * u.g0 + zeta * u.g1;
  }
};

/// The root by bisection: F grows with X. For orbits whose iteration does not come to an end.
[[gnu::noinline]] void bisect(const Orbit& orbit, Pack& root) {
  Pack low = Pack{} - 1, high = Pack{} + 1;
  const auto excess = [&](const Pack& x) __attribute__((always_inline)) {
    return orbit.excess(x, universal(orbit.beta, x));
  };
  for (int k = 0; k < 60; ++k) {
    low = excess(low) > 0 ? 2 * low : low;
    high = excess(high) < 0 ? 2 * high : high;
  }
  for (int k = 0; k < 120; ++k) {
    const Pack middle = (low + high) / 2;
    const auto beyond = excess(middle) > 0;
    high = beyond ? middle : high;
    low = beyond ? low : middle;
  }
  root = (low + high) / 2;
}

/// X from the first terms of its series in time where they are good, and from the mean motion.
[[gnu::always_inline]] inline Pack first_guess(const Orbit& orbit, const Pack& pull) {
  const Pack s = orbit.time / orbit.distance;
  const Pack bend = orbit.eta * s / orbit.distance;
  const Pack twist = orbit.zeta * s * s / orbit.distance;
  const Pack correction = bend * (bend - 1) / 2 - twist / 6;
  const Pack mean = orbit.beta * orbit.time / pull;
  const Pack far = orbit.beta > 0 ? mean : s;
  return magnitude(correction) < 0.3 ? s + s * correction : far;
}

/// Kepler's equation by the method of Laguerre and Conway (1986, Celest. Mech. 39, 199), which
/// triples the digits of a good guess and comes to an end from almost any.
[[gnu::always_inline]] inline Pack solved(const Orbit& orbit, const Pack& pull) {
  constexpr int most_iterations = 30;
  constexpr double good = 1e-6;
  Pack x = first_guess(orbit, pull);
  for (int k = 0; k < most_iterations; ++k) {
    const Universal u = universal(orbit.beta, x);
    const Pack f = orbit.excess(x, u), r = orbit.distance_at(u);
    const Pack change = 5 * f / (r + root(magnitude(16 * r * r - 20 * f * orbit.slope_at(u))));
    x -= change;
    // Not so for what is not a number, where a far guess overflowed.
    const Pack open = magnitude(change) <= good * magnitude(x) ? Pack{} : Pack{} + 1;
    if (largest_of(open) == 0) return x;
  }
  bisect(orbit, x);
  return x;
}

/// The part of `time` that is left of whole periods, where there are any.
[[gnu::always_inline]] inline Pack within_a_period(const Pack& pull, const Pack& beta,
                                                   double time) {
  const Pack periods =
      beta > 0 ? time * beta * root(magnitude(beta)) / (2 * std::numbers::pi * pull) : Pack{};
  Pack rest = Pack{} + time;
  if (!(largest_of(magnitude(periods)) > 0.5)) return rest;
  for (std::size_t k = 0; k < pack_size; ++k)
    if (periods[k] != 0) rest[k] = time - std::nearbyint(periods[k]) * (time / periods[k]);
  return rest;
}

}  // namespace

void move_on_orbits(const Pack& pull, double time, PackVector& place, PackVector& velocity) {
  const Pack r0 = root(dot(place, place));
  const Pack beta = 2 * pull / r0 - dot(velocity, velocity);
  const Orbit orbit{r0, beta, dot(place, velocity), pull - beta * r0,
                    within_a_period(pull, beta, time)};
  const Pack x = solved(orbit, pull);
  const Universal u = universal(beta, x);
  const Pack r = orbit.distance_at(u);
  const Pack f = pull * u.g2 / r0, g = orbit.time - pull * u.g3;
  const Pack f_rate = pull * u.g1 / (r0 * r), g_rate = pull * u.g2 / r;
  for (std::size_t d = 0; d < 3; ++d) {
    const Pack from = place[d], moving = velocity[d];
    place[d] = from + (g * moving - f * from);
    velocity[d] = moving - (f_rate * from + g_rate * moving);
  }
}

}  // namespace mote
