#include "mote/exact/gauss_panel.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

namespace mote {
namespace {

constexpr int points = GaussPanel::points;
using Legendre = std::array<long double, points + 1>;

/// Legendre polynomials of all degrees up to 16 at s.
Legendre legendre(long double s) {
  Legendre p{1, s};
  for (int m = 1; m < points; ++m) p[m + 1] = ((2 * m + 1) * s * p[m] - m * p[m - 1]) / (m + 1);
  return p;
}

/// Integral of P_m from 0 to the place of `at`: (2m + 1) P_m = (P_(m+1) - P_(m-1))'.
long double integral_of(int m, const Legendre& at, const Legendre& middle) {
  if (m == 0) return at[1];
  return (at[m + 1] - at[m - 1] - middle[m + 1] + middle[m - 1]) / (2 * m + 1);
}

GaussPanel made() {
  using Rule = boost::math::quadrature::gauss<long double, points>;
  GaussPanel panel{};
  std::array<long double, points> place, weight;
  for (int n = 0; n < points / 2; ++n) {
    const int up = points / 2 + n, down = points / 2 - 1 - n;
    place[up] = Rule::abscissa()[n];
    place[down] = -place[up];
    weight[up] = weight[down] = Rule::weights()[n];
  }
  const Legendre middle = legendre(0);
  for (int n = 0; n < points; ++n) {
    panel.place[n] = static_cast<double>(place[n]);
    panel.weight[n] = static_cast<double>(weight[n]);
    const Legendre to = legendre(place[n]);
    for (int k = 0; k < points; ++k) {
      // The polynomial that is 1 at place k alone has the coefficients (2m + 1)/2 w_k P_m(s_k).
      const Legendre at = legendre(place[k]);
      long double sum = 0;
      for (int m = 0; m < points; ++m)
        sum += (m + 0.5L) * weight[k] * at[m] * integral_of(m, to, middle);
      panel.from_middle[k][n] = static_cast<double>(sum);
    }
    for (int m : {points - 2, points - 1})
      panel.tail[m - (points - 2)][n] = static_cast<double>((m + 0.5L) * weight[n] * to[m]);
  }
  panel.end_gap = 1 - panel.place.back();
  for (int n = 1; n < points; ++n)
    panel.widest_gap = std::max(panel.widest_gap, panel.place[n] - panel.place[n - 1]);
  return panel;
}

}  // namespace

const GaussPanel& gauss_panel() {
  static const GaussPanel panel = made();
  return panel;
}

}  // namespace mote
