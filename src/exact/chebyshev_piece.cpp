#include "mote/exact/chebyshev_piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace mote {
namespace {

constexpr int nodes = ChebyshevPiece::degree + 1;
using Nodes = std::array<long double, nodes>;

/// Sum of a Chebyshev series up to a degree at s in [-1, 1], by Clenshaw's recurrence.
template <class Real>
Real series_sum(const ChebyshevPiece::Series<Real>& series, int highest, Real s) {
  Real last = 0, before = 0;
  for (int k = highest; k > 0; --k) {
    const Real next = 2 * s * last - before + series[k];
    before = last;
    last = next;
  }
  return s * last - before + series[0];
}

/// cos(pi m / (2 nodes)) for all m that the points and the transformation need.
const std::array<long double, 4 * nodes>& cosines() {
  static const auto table = [] {
    std::array<long double, 4 * nodes> values;
    for (int m = 0; m < 4 * nodes; ++m)
      values[m] = std::cos(std::numbers::pi_v<long double> * m / (2 * nodes));
    return values;
  }();
  return table;
}

double finite(const std::function<double(double)>& function, double place) {
  const double value = function(place);
  if (std::isfinite(value)) return value;
  throw std::invalid_argument(
      fmt::format("the start velocity is not a number at x = {:.6g}", place));
}

ChebyshevPiece::Series<long double> coefficients(const Nodes& sample) {
  ChebyshevPiece::Series<long double> series{};
  for (int k = 0; k < nodes; ++k) {
    for (int n = 0; n < nodes; ++n)
      series[k] += sample[n] * cosines()[k * (2 * n + 1) % (4 * nodes)];
    series[k] *= (k == 0 ? 1.0L : 2.0L) / nodes;
  }
  return series;
}

/// The steepest slope between neighbouring samples.
double steepest(const Nodes& sample, double half) {
  long double slope = 0;
  for (int n = 1; n < nodes; ++n)
    slope = std::max(slope, std::abs((sample[n] - sample[n - 1]) /
                                     (cosines()[2 * n + 1] - cosines()[2 * n - 1])));
  return static_cast<double>(slope) / half;
}

}  // namespace

ChebyshevPiece::ChebyshevPiece(const std::function<double(double)>& function, double lower_end,
                               double upper_end, double scale, int checks)
    : lower(lower_end), upper(upper_end) {
  const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  Nodes sample;
  for (int n = 0; n < nodes; ++n) {
    sample[n] = finite(function, middle + half * static_cast<double>(cosines()[2 * n + 1]));
    largest = std::max(largest, static_cast<double>(std::abs(sample[n])));
  }
  const auto series = coefficients(sample);
  for (int k = 1; k <= degree + 1; ++k)
    sum[k] =
        0.5L * half * ((k == 1 ? 2 : 1) * series[k - 1] - (k < degree ? series[k + 1] : 0)) / k;
  sum[0] = -series_sum(sum, degree + 1, -1.0L);

  constexpr double rounding = std::numeric_limits<double>::epsilon();
  const double size = std::max(scale, largest);
  for (int k = 0; k <= degree; ++k) {
    value[k] = static_cast<double>(series[k]);
    if (std::abs(value[k]) > 0.5 * rounding * size) highest = k;
  }
  sum_in_the_middle = series_sum(sum, highest + 1, 0.0L);
  const double farthest = std::max(std::abs(lower), std::abs(upper));
  const double allowed = rounding * (16 * size + 2 * farthest * steepest(sample, half));
  resolved = std::abs(value[degree]) + std::abs(value[degree - 1]) + std::abs(value[degree - 2]) <=
             allowed;
  for (int k = 0; resolved && k < checks; ++k) {
    const double place = lower + (upper - lower) * (k + 0.5) / checks;
    resolved = std::abs((*this)(place)-finite(function, place)) <= 4 * allowed;
  }
}

double ChebyshevPiece::operator()(double place) const {
  const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  return series_sum(value, highest, (place - middle) / half);
}

long double ChebyshevPiece::integral(long double place) const {
  const long double middle = 0.5L * (static_cast<long double>(lower) + upper);
  const long double half = 0.5L * (static_cast<long double>(upper) - lower);
  return before + series_sum(sum, highest + 1, (place - middle) / half);
}

}  // namespace mote
