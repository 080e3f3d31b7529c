#include "mote/exact/cole_hopf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mote/exact/gauss_panel.hpp"

namespace mote {
namespace {

using Values = GaussPanel::Values;
constexpr int points = GaussPanel::points;

/// exp(-44) of the largest weight is below the rounding of a sum, over any width that matters.
constexpr double negligible = 44;

/// A part of one piece of the start, and the weight's exponent g = F/(2 nu) on it. Its ends are
/// long double: g is steep beside a jump, and an end that is off by a rounding of a place would
/// show.
struct Panel {
  const ChebyshevPiece* piece;
  long double lower, upper, middle;
  double half;
  double away = 0;           ///< of the middle from the place
  long double exponent = 0;  ///< g in the middle
  Values start{}, rise{};    ///< u0, and g less that in the middle
  Values weight{};           ///< exp(-g), that at the least g being 1
  double lowest = 0;         ///< bound from below of g - exponent on all of the panel

  Panel(const ChebyshevPiece* of, long double from, long double to)
      : piece(of),
        lower(from),
        upper(to),
        middle(0.5L * (from + to)),
        half(static_cast<double>(0.5L * (to - from))) {}

  void sample(double place, double time, double viscosity);
  bool resolve(long double least_exponent);
  double least() const { return *std::ranges::min_element(rise); }
};

/// Fills what is known of the start and the exponent.
void Panel::sample(double place, double time, double viscosity) {
  const GaussPanel& gauss = gauss_panel();
  const double width = piece->upper - piece->lower;
  const auto from = static_cast<double>(2 * middle - piece->upper - piece->lower) / width;
  const double scale = 2 * half / width;
  Values s, last{}, before{}, slope;
  for (int n = 0; n < points; ++n) s[n] = from + scale * gauss.place[n];
  for (int k = piece->highest; k > 0; --k)
    for (int n = 0; n < points; ++n) {
      const double next = 2 * s[n] * last[n] - before[n] + piece->value[k];
      before[n] = last[n];
      last[n] = next;
    }
  const long double far = middle - place;
  exponent = (piece->integral(middle) + far * far / (2 * time)) / (2 * viscosity);
  away = static_cast<double>(far);
  const double unit = half / (2 * viscosity);
  for (int n = 0; n < points; ++n) {
    start[n] = s[n] * last[n] - before[n] + piece->value[0];
    slope[n] = unit * (start[n] + (away + half * gauss.place[n]) / time);  // dg/ds
  }
  for (int k = 0; k < points; ++k)
    for (int n = 0; n < points; ++n) rise[n] += gauss.from_middle[k][n] * slope[k];
  // Between two points g lies at most curvature gap^2/8 below the lower one. Twice that is left for
  // a curvature that is larger between the points than their slopes say.
  double curvature = 0;
  for (int n = 1; n < points; ++n)
    curvature =
        std::max(curvature, (slope[n] - slope[n - 1]) / (gauss.place[n] - gauss.place[n - 1]));
  const double dip = curvature * gauss.widest_gap * gauss.widest_gap / 4;
  const double end_dip =
      2 * gauss.end_gap * std::max(std::abs(slope.front()), std::abs(slope.back()));
  lowest = least() - std::max(dip, end_dip);
}

/// Fills the weights, and says whether their sum is the integral to rounding: for an entire
/// function a Legendre coefficient below 1e-7 at degree 15 means one below 1e-14 at degree 32, the
/// first that the sum gets wrong. A panel that weighs little by itself needs less.
bool Panel::resolve(long double least_exponent) {
  constexpr double most = 20, small = 1e-7;
  const auto [least, largest] = std::ranges::minmax(rise);
  if (largest - least > most) return false;
  const auto& [degree_14, degree_15] = gauss_panel().tail;
  double first = 0, second = 0;
  for (int n = 0; n < points; ++n) {
    weight[n] = std::exp(least - rise[n]);
    first += degree_14[n] * weight[n];
    second += degree_15[n] * weight[n];
  }
  const double above = static_cast<double>(exponent + least - least_exponent);
  return std::abs(first) + std::abs(second) <= small * std::exp(0.2 * above);
}

/// Weighted sums over panels in two passes: means first, then products about the means.
ColeHopf::Motion motion(std::vector<Panel>& panels, long double least, double two_nu_t) {
  const GaussPanel& gauss = gauss_panel();
  double total = 0, velocity = 0, source = 0;
  for (Panel& panel : panels) {
    const double share =
        panel.half * std::exp(-static_cast<double>(panel.exponent + panel.least() - least));
    for (int n = 0; n < points; ++n) {
      const double w = panel.weight[n] *= share * gauss.weight[n];
      total += w;
      velocity += w * panel.start[n];
      source += w * (panel.away + panel.half * gauss.place[n]);
    }
  }
  velocity /= total;
  source /= total;
  double product = 0;
  for (const Panel& panel : panels) {
    const double offset = panel.away - source;
    for (int n = 0; n < points; ++n)
      product +=
          panel.weight[n] * (panel.start[n] - velocity) * (offset + panel.half * gauss.place[n]);
  }
  return {velocity, product / total / two_nu_t};
}

}  // namespace

ColeHopf::ColeHopf(std::function<double(double)> start, double lower, double upper,
                   double viscosity)
    : start_(std::move(start), lower, upper), length_(upper - lower), viscosity_(viscosity) {}

/// F(y) is above F(x) from where (x - y)^2/(2 t) exceeds the largest |u0| times |x - y|.
double ColeHopf::reach(double time) const {
  const double drift = start_.largest() * time;
  return drift + std::sqrt(drift * drift + 4 * viscosity_ * time * negligible);
}

void ColeHopf::cover(double lower, double upper, double time) {
  // What is covered anew may be faster, and so reach farther.
  for (double last = -1; last != reach(time);) {
    last = reach(time);
    start_.cover(lower - last, upper + last);
  }
}

ColeHopf::Motion ColeHopf::operator()(double place, double time) const {
  const double lower = place - reach(time), upper = place + reach(time);
  // The minimum of F is not above F at the place itself.
  const long double enough =
      start_.pieces()[start_.piece_at(place)].integral(place) + 2 * viscosity_ * negligible;
  std::vector<Panel> open, next, resolved;
  for (std::size_t k = start_.piece_at(lower); k < start_.pieces().size(); ++k) {
    const ChebyshevPiece& piece = start_.pieces()[k];
    if (piece.lower >= upper) break;
    const double away = std::max({0.0, piece.lower - place, place - piece.upper});
    if (piece.lowest_integral() + away * away / (2 * time) <= enough)
      open.emplace_back(&piece, std::max(lower, piece.lower), std::min(upper, piece.upper));
  }
  long double least = std::numeric_limits<long double>::infinity();
  while (!open.empty()) {
    for (Panel& panel : open) {
      panel.sample(place, time, viscosity_);
      least = std::min(least, panel.exponent + panel.least());
    }
    next.clear();
    for (Panel& panel : open) {
      if (panel.exponent + panel.lowest > least + negligible) continue;
      if (panel.resolve(least)) {
        resolved.push_back(panel);
      } else {
        next.emplace_back(panel.piece, panel.lower, panel.middle);
        next.emplace_back(panel.piece, panel.middle, panel.upper);
      }
    }
    std::swap(open, next);
  }
  return motion(resolved, least, 2 * viscosity_ * time);
}

}  // namespace mote
