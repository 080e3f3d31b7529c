#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "mote/xivas/simplex_mesh.hpp"

namespace mote {

/// A lattice of `count` spacings a side over the box from 0 to 1, its inner points moved by up to
/// `jitter` spacings along every axis.
template <int D>
std::vector<double> lattice_points(int count, double jitter) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> points;
  const int side = count + 1, total = D == 2 ? side * side : side * side * side;
  for (int n = 0; n < total; ++n) {
    int place[3] = {n % side, n / side % side, n / side / side};
    bool inner = true;
    for (int d = 0; d < D; ++d) inner = inner && place[d] > 0 && place[d] < count;
    for (int d = 0; d < D; ++d)
      points.push_back((place[d] + (inner ? jitter * unit(random) : 0)) / count);
  }
  return points;
}

template <int D>
SimplexMesh<D> lattice_mesh(int count, double jitter) {
  return SimplexMesh<D>(lattice_points<D>(count, jitter));
}

/// The values of a field at the points of a mesh.
template <int D>
std::vector<double> sampled(const SimplexMesh<D>& mesh,
                            const std::function<Vec<D>(const Vec<D>&)>& field) {
  std::vector<double> values;
  for (Index i = 0; i < mesh.point_count(); ++i) {
    const Vec<D> value = field(mesh.point(i));
    values.insert(values.end(), value.data(), value.data() + D);
  }
  return values;
}

template <int D>
Vec<D> random_place(std::mt19937_64& random, double lower = 0, double upper = 1) {
  std::uniform_real_distribution<double> uniform(lower, upper);
  Vec<D> place;
  for (int d = 0; d < D; ++d) place[d] = uniform(random);
  return place;
}

}  // namespace mote
