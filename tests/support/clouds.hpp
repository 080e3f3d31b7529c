#pragma once

#include <cmath>
#include <numeric>
#include <utility>

#include "mote/particles/points.hpp"
#include "support/random.hpp"

namespace mote::test {

/// What a cloud looks like: a lattice of `side` points a direction, unit spacing, every point
/// moved by up to `jitter` and its mass, density and length varied by up to `variation`.
struct CloudShape {
  Index side;
  double jitter = 0.2;
  double variation = 0.3;
  std::uint64_t seed = 1;
};

/// Puts the points in random order, so that their numbers say nothing about their places.
template <int D>
void shuffle(Points<D>& points, std::uint64_t seed) {
  Draws draws(seed);
  for (Index i = points.size() - 1; i > 0; --i) {
    const auto j = static_cast<Index>(draws.below(static_cast<std::size_t>(i) + 1));
    for (int d = 0; d < D; ++d) std::swap(points.position[i * D + d], points.position[j * D + d]);
    for (auto* values : {&points.mass, &points.density, &points.length})
      std::swap((*values)[i], (*values)[j]);
  }
}

/// A jittered lattice in random order. Three quarters of its points are receivers.
template <int D>
Points<D> jittered_cloud(const CloudShape& shape) {
  Index count = 1;
  for (int d = 0; d < D; ++d) count *= shape.side;
  Points<D> points;
  points.resize(count, count - count / 4);
  Draws draws(shape.seed);
  const auto varied = [&] { return 1 + draws.uniform(-shape.variation, shape.variation); };
  for (Index i = 0; i < count; ++i) {
    Index place = i;
    for (int d = 0; d < D; ++d, place /= shape.side)
      points.position[i * D + d] = place % shape.side + draws.uniform(-shape.jitter, shape.jitter);
    points.mass[i] = varied();
    points.density[i] = varied();
    points.length[i] = varied();
  }
  shuffle(points, shape.seed + 1);
  return points;
}

/// Points of a line at these places, all of them receivers, of these lengths.
inline Points<1> line_points(std::vector<double> position, std::vector<double> length) {
  Points<1> points;
  const auto count = static_cast<Index>(position.size());
  points.resize(count, count);
  points.position = std::move(position);
  points.length = std::move(length);
  points.mass.assign(points.length.size(), 1);
  points.density.assign(points.length.size(), 1);
  return points;
}

inline Points<1> line_points(std::vector<double> position) {
  std::vector<double> length(position.size(), 1);
  return line_points(std::move(position), std::move(length));
}

}  // namespace mote::test
