#include "mote/sums/power_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"
#include "mote/sums/complex_lanes.hpp"

namespace mote {
namespace {

/// Points that are multiplied side by side, so that no product waits for the one before.
constexpr std::size_t chains = 4;
constexpr std::size_t block = chains * lane_count;
using Block = std::array<ComplexLanes, chains>;

/// Sources whose terms are added up together; fixed, so that the order of the sums is.
constexpr std::size_t piece = 128 * block;

/// A point, and how far it is from a centre.
struct Distance {
  std::size_t point = 0;
  double length = 0;
};

struct Distances {
  Distance least, largest;
};

Distances distances(std::span<const Complex> points, Complex centre) {
  std::size_t nearest = 0, farthest = 0;
  double least = std::norm(points[0] - centre), largest = least;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double square = std::norm(points[i] - centre);
    if (square < least) least = square, nearest = i;
    if (square > largest) largest = square, farthest = i;
  }
  return {{nearest, std::abs(points[nearest] - centre)},
          {farthest, std::abs(points[farthest] - centre)}};
}

/// Sources and targets as a centre sees them: one of the two should be within the other.
struct Parting {
  Complex centre;
  bool sources_inside;
  Distance inner, outer;  ///< the farthest point of those inside, the nearest of those outside

  double ratio() const {
    return outer.length > 0 ? inner.length / outer.length : std::numeric_limits<double>::infinity();
  }
  double gap() const { return outer.length - inner.length; }
};

Parting parting_about(Complex centre, std::span<const Complex> targets,
                      std::span<const Complex> sources) {
  const Distances s = distances(targets, centre), t = distances(sources, centre);
  const Parting inside{centre, true, t.largest, s.least},
      outside{centre, false, s.largest, t.least};
  return inside.ratio() <= outside.ratio() ? inside : outside;
}

/// The middle of the smallest upright rectangle around the points.
Complex middle(std::span<const Complex> points) {
  const auto x = std::ranges::minmax(points, {}, [](Complex z) { return z.real(); });
  const auto y = std::ranges::minmax(points, {}, [](Complex z) { return z.imag(); });
  return {0.5 * x.min.real() + 0.5 * x.max.real(), 0.5 * y.min.imag() + 0.5 * y.max.imag()};
}

Parting best_parting(std::span<const Complex> targets, std::span<const Complex> sources) {
  Parting best = parting_about(0, targets, sources);
  for (const Complex centre : {middle(sources), middle(targets)}) {
    const Parting parting = parting_about(centre, targets, sources);
    if (parting.ratio() < best.ratio()) best = parting;
  }
  return best;
}

Complex direct_sum(Complex target, std::span<const Complex> sources,
                   std::span<const Complex> strengths) {
  double re = 0, im = 0;
  for (std::size_t j = 0; j < sources.size(); ++j) {
    const Complex difference = target - sources[j], v = strengths[j];
    const double inverse = 1 / std::norm(difference);
    re += inverse * (v.real() * difference.real() + v.imag() * difference.imag());
    im += inverse * (v.imag() * difference.real() - v.real() * difference.imag());
  }
  return {re, im};
}

/// The largest |c_i| of the target that decides the ratio and of some more, or of all if there are
/// few: less than the largest of all, and so a safe measure of errors.
double largest_sum(const Parting& parting, std::span<const Complex> targets,
                   std::span<const Complex> sources, std::span<const Complex> strengths) {
  constexpr std::size_t samples = 16;
  std::array<double, samples> size{};
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(sources.size()))
  for (std::size_t k = 0; k < samples; ++k) {
    const std::size_t deciding = parting.sources_inside ? parting.outer.point : parting.inner.point;
    const std::size_t i = k == 0 ? deciding : k * targets.size() / samples;
    size[k] = std::abs(direct_sum(targets[i], sources, strengths));
  }
  return std::ranges::max(size);
}

/// How many terms the bound of the error needs. Sums so small that strengths cancel to rounding
/// have no relative error to speak of.
double terms_needed(const Parting& parting, std::span<const Complex> strengths, double largest,
                    double tolerance) {
  double total = 0;
  for (const Complex v : strengths) total += std::abs(v);
  const double bound = total / parting.gap();
  if (bound == 0) return 1;
  const double size = std::max(largest / bound, std::numeric_limits<double>::epsilon());
  return std::max(std::ceil(std::log(tolerance * size) / std::log(parting.ratio())), 1.0);
}

[[noreturn]] void refuse(const Parting& parting, const std::string& reason) {
  const bool inside = parting.sources_inside;
  throw InputError(fmt::format(
      "power_series needs sources and targets that a circle parts: about ({:.6g}, {:.6g}) {} {} "
      "lies {:.6g} times as far out as {} {}, {}; the methods multipole and direct serve any "
      "points",
      parting.centre.real(), parting.centre.imag(), inside ? "source" : "target",
      parting.inner.point, parting.ratio(), inside ? "target" : "source", parting.outer.point,
      reason));
}

/// sum_k m_k x^k with x = R/(s - centre) times 1/(s - centre), (11), or x = (s - centre)/R times
/// -1, (12). The radius R keeps the powers from overflow.
class Series {
 public:
  Series(const Parting& parting, std::size_t terms) : parting_(parting), moments_(terms) {}

  /// m_k = sum_j v_j x^k with x = (t - centre)/R, (11), or v_j/(t - centre) x^k with
  /// x = R/(t - centre), (12).
  void sum_up(std::span<const Complex> sources, std::span<const Complex> strengths) {
    const std::size_t pieces = (sources.size() + piece - 1) / piece;
    std::vector<Complex> moments(pieces * moments_.size());
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(sources.size()))
    for (std::size_t p = 0; p < pieces; ++p) {
      const std::size_t count = std::min(piece, sources.size() - p * piece);
      sum_up_piece(sources.subspan(p * piece, count), strengths.subspan(p * piece, count),
                   std::span(moments).subspan(p * moments_.size(), moments_.size()));
    }
    for (std::size_t m = 0; m < moments.size(); ++m) moments_[m % moments_.size()] += moments[m];
  }

  void evaluate(std::span<const Complex> targets, std::span<Complex> result) const {
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(targets.size()))
    for (std::size_t first = 0; first < targets.size(); first += block) {
      const std::size_t count = std::min(block, targets.size() - first);
      evaluate_block(targets.subspan(first, count), result.subspan(first, count));
    }
  }

 private:
  /// The base of the powers of a point inside or outside.
  Complex base(Complex place, bool inside) const {
    const double radius = parting_.outer.length;
    return inside ? place / radius : radius / place;
  }

  void sum_up_piece(std::span<const Complex> sources, std::span<const Complex> strengths,
                    std::span<Complex> moments) const {
    std::vector<ComplexLanes> sums(moments.size());
    for (std::size_t first = 0; first < sources.size(); first += block) {
      const std::size_t count = std::min(block, sources.size() - first);
      add_block(sources.subspan(first, count), strengths.subspan(first, count), sums);
    }
    std::ranges::transform(sums, moments.begin(), [](const auto& sum) { return sum_of(sum); });
  }

  void add_block(std::span<const Complex> sources, std::span<const Complex> strengths,
                 std::span<ComplexLanes> sums) const {
    std::array<Complex, block> weight{}, x{};
    for (std::size_t j = 0; j < sources.size(); ++j) {
      const Complex place = sources[j] - parting_.centre;
      weight[j] = parting_.sources_inside ? strengths[j] : strengths[j] / place;
      x[j] = base(place, parting_.sources_inside);
    }
    Block power = blocked(weight);
    const Block factor = blocked(x);
    for (ComplexLanes& sum : sums)
      for (std::size_t c = 0; c < chains; ++c) {
        sum += power[c];
        power[c] *= factor[c];
      }
  }

  void evaluate_block(std::span<const Complex> targets, std::span<Complex> result) const {
    std::array<Complex, block> x{};
    for (std::size_t i = 0; i < targets.size(); ++i)
      x[i] = base(targets[i] - parting_.centre, !parting_.sources_inside);
    const Block factor = blocked(x);
    Block value{};
    for (std::size_t k = moments_.size(); k-- > 0;)
      for (std::size_t c = 0; c < chains; ++c) {
        value[c] *= factor[c];
        value[c] += ComplexLanes(moments_[k]);
      }
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Complex sum = value[i / lane_count][i % lane_count];
      result[i] = parting_.sources_inside ? sum / (targets[i] - parting_.centre) : -sum;
    }
  }

  static Block blocked(std::span<const Complex, block> numbers) {
    Block lanes;
    for (std::size_t c = 0; c < chains; ++c)
      lanes[c] = ComplexLanes(numbers.subspan(c * lane_count, lane_count));
    return lanes;
  }

  Parting parting_;
  std::vector<Complex> moments_;
};

}  // namespace

void power_series(std::span<const Complex> targets, std::span<const Complex> sources,
                  std::span<const Complex> strengths, double tolerance, std::span<Complex> result) {
  std::ranges::fill(result, Complex{});
  if (targets.empty() || sources.empty()) return;
  const Parting parting = best_parting(targets, sources);
  if (!(parting.ratio() < 1)) refuse(parting, "where a series needs a ratio below 1");
  const double largest = largest_sum(parting, targets, sources, strengths);
  const double terms = terms_needed(parting, strengths, largest, tolerance);
  if (terms > most_series_terms)
    refuse(parting, fmt::format("which takes {:.0f} terms, and {} are the most that make sense",
                                terms, most_series_terms));
  Series series(parting, static_cast<std::size_t>(terms));
  series.sum_up(sources, strengths);
  series.evaluate(targets, result);
}

}  // namespace mote
