#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <vector>

namespace mote::test {

using Big = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                          boost::multiprecision::et_off>;

/// u and u_x with 50 digits, of which some 25 are right.
struct BigMotion {
  Big velocity, slope;
};

/// u_x from u by a central difference: nothing that the solution under test knows.
inline BigMotion differentiated(const std::function<Big(Big)>& velocity, double place) {
  const Big step("1e-14");
  const Big x = place;
  return {velocity(x), (velocity(x + step) - velocity(x - step)) / (2 * step)};
}

/// A start made of straight lines between corners.
struct Corners {
  std::vector<Big> place, value;
};

/// u = <(x - y)/t>, the form of Cole (1951) before any integration by parts, as Gauss-Legendre sums
/// over panels between corners of at most one and a half of the narrowest width that a weight has.
inline Big velocity_from_corners(const Corners& start, const Big& x, double time,
                                 double viscosity) {
  using Rule = boost::math::quadrature::gauss<Big, 20>;
  const Big t = time, two_nu = 2 * Big(viscosity), fastest = 1, steepest = 1;
  const Big width = 1.5 * sqrt(two_nu / (1 / t + steepest));
  const Big reach = 2 * fastest * t + sqrt(2 * two_nu * t * 100);
  Big least = 1e30, weight = 0, velocity = 0;
  for (const bool is_search : {true, false}) {
    Big before = 0;
    for (std::size_t k = 0; k + 1 < start.place.size(); ++k) {
      const Big from = start.place[k], length = start.place[k + 1] - from;
      const Big slope = (start.value[k + 1] - start.value[k]) / length;
      const auto exponent = [&](const Big& y) -> Big {
        const Big along = y - from, away = x - y;
        const Big integral = before + along * (start.value[k] + along * slope / 2);
        return (integral + away * away / (2 * t)) / two_nu;
      };
      const Big lower = std::max(from, x - reach);
      const Big upper = std::min(start.place[k + 1], x + reach);
      const int panels = lower < upper ? static_cast<int>((upper - lower) / width) + 1 : 0;
      for (int p = 0; p < panels; ++p) {
        const Big half = (upper - lower) / (2 * panels), middle = lower + (2 * p + 1) * half;
        const Big in_the_middle = exponent(middle);
        if (is_search) least = std::min(least, in_the_middle);
        if (is_search || in_the_middle - least > 90) continue;
        const auto add = [&](const Big& y, const Big& share) {
          const Big w = share * half * exp(least - exponent(y));
          weight += w;
          velocity += w * (x - y) / t;
        };
        for (std::size_t n = 0; n < Rule::abscissa().size(); ++n) {
          add(middle + half * Rule::abscissa()[n], Rule::weights()[n]);
          add(middle - half * Rule::abscissa()[n], Rule::weights()[n]);
        }
      }
      before += length * (start.value[k] + length * slope / 2);
    }
  }
  return velocity / weight;
}

/// The start u0 = left for x < 0, right for x > 0 (Hopf 1950).
inline Big velocity_from_jump(double left, double right, const Big& x, double time,
                              double viscosity) {
  const Big t = time, nu = viscosity;
  const auto share = [&](const Big& u, int side) -> Big {
    return exp(-u * (x - u * t / 2) / (2 * nu)) *
           boost::math::erfc(Big(side * (x - u * t) / sqrt(4 * nu * t)));
  };
  const Big a = share(left, 1), b = share(right, -1);
  return (left * a + right * b) / (a + b);
}

/// The start u0 = -sin(pi x) as the series of Cole (1951), (44): with z = 1/(2 pi nu)
///   theta = I_0(z) + 2 sum I_n(z) exp(-n^2 pi^2 nu t) cos(n pi (x + 1)),  u = -2 nu theta_x/theta.
inline Big velocity_from_sine(const Big& x, double time, double viscosity) {
  const Big pi = boost::math::constants::pi<Big>(), nu = viscosity, z = 1 / (2 * pi * nu);
  Big theta = boost::math::cyl_bessel_i(0, z), slope = 0;
  for (int n = 1; n < 200; ++n) {
    const Big share = 2 * boost::math::cyl_bessel_i(n, z) * exp(-n * n * pi * pi * nu * time);
    theta += share * cos(n * pi * (x + 1));
    slope -= share * n * pi * sin(n * pi * (x + 1));
    if (share < theta * Big("1e-40")) break;
  }
  return -2 * nu * slope / theta;
}

}  // namespace mote::test
