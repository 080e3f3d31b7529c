#pragma once

#include <cmath>
#include <vector>

#include "mote/neighbours/search.hpp"
#include "mote/solvers/sparse_matrix.hpp"
#include "support/random.hpp"

namespace mote::test {

/// A square or cube of `side` points a direction, unit spacing, every point moved by up to `jitter`
/// and some of them left out at random. The top layer is held, unless the system is to be singular.
struct PoissonShape {
  Index side;
  double left_out = 0;
  bool held_top = true;
  double jitter = 0.2;
  std::uint64_t seed = 1;
};

/// How far the weight reaches, in spacings: 21 entries a row in 2D, 57 in 3D, less at the rim.
inline constexpr double poisson_reach = 2.4;

/// The weight of MPS, Koshizuka & Oka, Nucl. Sci. Eng. 123 (1996) 421, eq. (4).
inline double mps_weight(double distance) { return poisson_reach / distance - 1; }

/// The points of a shape in lattice order, x fastest: first those whose values are unknown, then
/// those that are held.
template <int D>
Points<D> poisson_points(const PoissonShape& shape) {
  Index count = 1;
  for (int d = 0; d < D; ++d) count *= shape.side;
  const Index unknown = shape.held_top ? count - count / shape.side : count;
  Draws draws(shape.seed);
  std::vector<double> position;
  Index receivers = 0;
  for (Index i = 0; i < count; ++i) {
    Vec<D> x;
    Index place = i;
    for (int d = 0; d < D; ++d, place /= shape.side)
      x[d] = place % shape.side + draws.uniform(-shape.jitter, shape.jitter);
    if (i < unknown && draws.uniform(0, 1) < shape.left_out) continue;
    if (i < unknown) ++receivers;
    position.insert(position.end(), x.begin(), x.end());
  }
  Points<D> points;
  points.resize(static_cast<Index>(position.size()) / D, receivers);
  points.position = std::move(position);
  points.length.assign(points.length.size(), 1);
  return points;
}

/// The matrix of sum_j w(|x_ij|) (p_i - p_j) = b_i, where p is 0 at points that are held.
template <int D>
SparseMatrix poisson_matrix(const PoissonShape& shape) {
  const auto points = poisson_points<D>(shape);
  NeighbourLists lists;
  make_search<D>("cell_grid")->find(points, {.support = poisson_reach}, lists);
  SparseMatrix matrix = matrix_of_zeros(lists);
  for (Index i = 0; i < points.receivers; ++i) {
    const auto weight = [&](Index j) { return mps_weight((points.at(i) - points.at(j)).norm()); };
    double sum = 0;
    for (const Index j : lists[i]) sum += weight(j);
    const auto columns = row_columns(matrix, i);
    const auto values = row_values(matrix, i);
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = columns[k] == i ? sum : -weight(columns[k]);
  }
  return matrix;
}

/// A smooth part and a rough one.
inline std::vector<double> rough_and_smooth(Index size, std::uint64_t seed = 7) {
  auto values = Draws(seed).uniform(static_cast<std::size_t>(size), -1, 1);
  for (Index i = 0; i < size; ++i) values[i] += std::sin(3.0 * i / size);
  return values;
}

}  // namespace mote::test
