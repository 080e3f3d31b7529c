#pragma once

#include <array>
#include <numbers>

namespace mote::test {

/// Integral of f over [lower, upper] by Gauss-Legendre quadrature with five points on each of 240
/// panels, in long double. Break points at halves, thirds, quarters and fifths of the interval
/// fall between panels.
template <class Function>
long double panel_integral(Function f, long double lower, long double upper) {
  constexpr std::array<long double, 3> node{0, 0.538469310105683091036314420700208805L,
                                            0.906179845938663992797626878299392965L};
  constexpr std::array<long double, 3> weight{0.568888888888888888888888888888888889L,
                                              0.478628670499366468041291514835638193L,
                                              0.236926885056189087514264040719917363L};
  constexpr int panels = 240;
  const long double half = (upper - lower) / (2 * panels);
  long double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const long double middle = lower + (2 * panel + 1) * half;
    sum += weight[0] * f(middle);
    for (int k = 1; k < 3; ++k)
      sum += weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
  }
  return sum * half;
}

/// Integral over D-dimensional space of a function of the radius that vanishes beyond `support`.
template <int D, class Function>
long double radial_integral(Function f, long double support) {
  constexpr long double pi = std::numbers::pi_v<long double>;
  constexpr long double unit_sphere = D == 1 ? 2 : D == 2 ? 2 * pi : 4 * pi;
  const auto shell = [&](long double q) { return f(q) * (D == 1 ? 1 : D == 2 ? q : q * q); };
  return unit_sphere * panel_integral(shell, 0, support);
}

}  // namespace mote::test
