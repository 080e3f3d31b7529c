#pragma once

#include <cmath>
#include <functional>
#include <numbers>

namespace mote {

/// Integral of f over [lower, upper] by adaptive Gauss-Kronrod quadrature, to about 1e-15 of the
/// integral of |f|.
double line_integral(const std::function<double(double)>& f, double lower, double upper);

/// Integral over D-dimensional space of a function of the radius q that vanishes beyond `support`.
template <int D, class Function>
double space_integral(Function f, double support) {
  constexpr double pi = std::numbers::pi;
  constexpr double unit_sphere = D == 1 ? 2 : D == 2 ? 2 * pi : 4 * pi;
  return unit_sphere *
         line_integral([&](double q) { return f(q) * std::pow(q, D - 1); }, 0, support);
}

}  // namespace mote
