#include "mote/sums/periodic_vortices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {
namespace {

using std::numbers::pi;
namespace simd = std::experimental;

double wrapped(double x, double period) { return x - period * std::floor(x / period); }

/// Moves differences of more than half a period to the nearest image.
Lanes nearest(Lanes difference, double period) {
  simd::where(difference > period / 2, difference) -= period;
  simd::where(difference < -period / 2, difference) += period;
  return difference;
}

/// Beyond so many core sizes a gauss core is a point: exp(-9^2/2) < 1e-17.
constexpr double core_reach = 9;

}  // namespace

struct PeriodicVortices::Pack {
  Lanes x, y, sine, cosine, growing, falling;
};

/// Half angles of eight pairs: sine and cosine of t/2, sinh and cosh of a/2.
struct PeriodicVortices::Pair {
  Lanes x, y;  ///< target less source, of the nearest image
  Lanes sine, cosine, sinh, cosh;
};

PeriodicVortices::PeriodicVortices(const std::array<double, 2>& widths, std::string_view core)
    : turned_(widths[0] > widths[1]),
      length_(std::min(widths[0], widths[1])),
      height_(std::max(widths[0], widths[1])),
      has_cores_(core == "gauss") {
  const double b = 2 * pi * height_ / length_;
  for (std::size_t k = 0; k < far_.size(); ++k) {
    const auto n = static_cast<double>(k + 1);
    far_[k] = std::exp(-2 * n * b) / (1 - std::exp(-n * b));
  }
  row_growth_ = std::exp(b / 2);
  row_cosh_ = std::cosh(b / 2);
  row_sinh_ = std::sinh(b / 2);
}

/// A box on its side is mirrored in x = y, which turns vortices the other way round.
void PeriodicVortices::place(const Sources<2>& sources) {
  core_size_ = has_cores_ ? sources.core_size : 0;
  if (2 * core_reach * core_size_ > length_)
    throw InputError("model.core",
                     "the cores are so large that they overlap their own images: their size can be "
                     "at most 1/18 of the box");
  points_.resize(sources.strength.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double along = sources.position[2 * i + (turned_ ? 1 : 0)];
    const double across = sources.position[2 * i + (turned_ ? 0 : 1)];
    Point& point = points_[i];
    point.x = wrapped(along, length_);
    point.y = wrapped(across, height_);
    point.sine = std::sin(pi * point.x / length_);
    point.cosine = std::cos(pi * point.x / length_);
    point.growing = std::exp(pi * (point.y - height_ / 2) / length_);
    point.falling = 1 / point.growing;
    point.circulation = turned_ ? -sources.strength[i] : sources.strength[i];
  }
}

/// Eight points side by side; behind the last one it is repeated.
PeriodicVortices::Pack PeriodicVortices::pack_at(std::size_t first) const {
  const auto of = [&](double Point::*value) {
    return Lanes(
        [&](std::size_t k) { return points_[std::min(first + k, points_.size() - 1)].*value; });
  };
  return {of(&Point::x),      of(&Point::y),       of(&Point::sine),
          of(&Point::cosine), of(&Point::growing), of(&Point::falling)};
}

PeriodicVortices::Pair PeriodicVortices::pair_of(const Pack& targets, const Point& source) const {
  Pair pair;
  pair.x = nearest(targets.x - source.x, length_);
  const Lanes y = targets.y - source.y;
  pair.y = nearest(y, height_);
  pair.sine = targets.sine * source.cosine - targets.cosine * source.sine;
  pair.cosine = targets.cosine * source.cosine + targets.sine * source.sine;
  Lanes growing = targets.growing * source.falling, falling = targets.falling * source.growing;
  const auto above = y > height_ / 2, below = y < -height_ / 2;
  simd::where(above, growing) /= row_growth_;
  simd::where(above, falling) *= row_growth_;
  simd::where(below, growing) *= row_growth_;
  simd::where(below, falling) /= row_growth_;
  pair.sinh = 0.5 * (growing - falling);
  pair.cosh = 0.5 * (growing + falling);
  return pair;
}

void PeriodicVortices::add(const Pair& pair, double circulation, std::array<Lanes, 2>& sums) const {
  const Lanes square = pair.sine * pair.sine, product = pair.sine * pair.cosine;
  Lanes u = 0, v = 0;
  const auto add_row = [&](const Lanes& sinh, const Lanes& cosh) {
    Lanes size = sinh * sinh + square;  // (cosh a - cos t)/2
    simd::where(size == 0.0, size) = 1;
    const Lanes inverse = 1 / size;
    u -= sinh * cosh * inverse;
    v += product * inverse;
  };
  add_row(pair.sinh, pair.cosh);
  add_row(pair.sinh * row_cosh_ - pair.cosh * row_sinh_,
          pair.cosh * row_cosh_ - pair.sinh * row_sinh_);
  add_row(pair.sinh * row_cosh_ + pair.cosh * row_sinh_,
          pair.cosh * row_cosh_ + pair.sinh * row_sinh_);
  const Lanes sine = 2 * product, cosine = 1 - 2 * square;
  const Lanes sinh = 2 * pair.sinh * pair.cosh, cosh = 1 + 2 * pair.sinh * pair.sinh;
  Lanes sine_n = sine, cosine_n = cosine, sinh_n = sinh, cosh_n = cosh;
  for (std::size_t n = 0; n < far_.size(); ++n) {
    u += 4 * far_[n] * sinh_n * cosine_n;
    v += 4 * far_[n] * cosh_n * sine_n;
    const Lanes next_sine = sine_n * cosine + cosine_n * sine;
    const Lanes next_sinh = sinh_n * cosh + cosh_n * sinh;
    cosine_n = cosine_n * cosine - sine_n * sine;
    cosh_n = cosh_n * cosh + sinh_n * sinh;
    sine_n = next_sine;
    sinh_n = next_sinh;
  }
  const double scale = circulation / (2 * length_);
  sums[0] += scale * u + circulation / (length_ * height_) * pair.y;
  sums[1] += scale * v;
}

/// What the core of the nearest image lacks to a point, q - 1 = -exp(-r^2/(2 size^2)).
void PeriodicVortices::add_core(const Pair& pair, double circulation,
                                std::array<Lanes, 2>& sums) const {
  Lanes squared = pair.x * pair.x + pair.y * pair.y;
  const double reach = core_reach * core_size_;
  if (simd::none_of(squared < reach * reach)) return;
  simd::where(squared == 0.0, squared) = 1;
  const Lanes lack =
      circulation / (2 * pi) * simd::exp(squared * (-0.5 / (core_size_ * core_size_))) / squared;
  sums[0] += lack * pair.y;
  sums[1] -= lack * pair.x;
}

void PeriodicVortices::at_sources(const Sources<2>& sources, std::span<double> velocity) {
  place(sources);
  const auto packs = static_cast<Index>(packs_for(points_.size()));
#pragma omp parallel for schedule(static) if (packs > 4)
  for (Index p = 0; p < packs; ++p) {
    const std::size_t first = static_cast<std::size_t>(p) * lane_count;
    const Pack targets = pack_at(first);
    std::array<Lanes, 2> sums{Lanes(0), Lanes(0)};
    for (const Point& source : points_) {
      const Pair pair = pair_of(targets, source);
      add(pair, source.circulation, sums);
      if (core_size_ > 0) add_core(pair, source.circulation, sums);
    }
    if (turned_) std::swap(sums[0], sums[1]);
    for (std::size_t k = 0; k < std::min(lane_count, points_.size() - first); ++k)
      for (std::size_t d = 0; d < 2; ++d) velocity[2 * (first + k) + d] = sums[d][k];
  }
}

void PeriodicVortices::vorticity_at_sources(const Sources<2>& sources,
                                            std::span<double> vorticity) {
  place(sources);
  double mean = 0;
  for (const double circulation : sources.strength) mean += circulation / (length_ * height_);
  const double squared_size = core_size_ * core_size_, reach = core_reach * core_size_;
  const auto count = static_cast<Index>(points_.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < count; ++i) {
    const Point& target = points_[static_cast<std::size_t>(i)];
    double sum = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const double x = std::remainder(target.x - points_[j].x, length_);
      const double y = std::remainder(target.y - points_[j].y, height_);
      const double squared = x * x + y * y;
      if (squared < reach * reach)
        sum += sources.strength[j] * std::exp(-0.5 * squared / squared_size);
    }
    vorticity[static_cast<std::size_t>(i)] = sum / (2 * pi * squared_size) - mean;
  }
}

}  // namespace mote
