#pragma once

#include <functional>

#include "mote/exact/gravitating_sheets.hpp"
#include "support/random.hpp"

namespace mote::test {

using Profile = std::function<double(double)>;

/// Cells of random lengths on [0, 4] at rest, of a density that depends on their middle.
inline SheetCells cells_at_rest(const Profile& density, double gravity, std::size_t count = 41) {
  Draws draws(31);
  SheetCells cells{.lower = 0, .gravity = gravity};
  cells.length = draws.uniform(count, 0.5, 1.5);
  double sum = 0;
  for (const double length : cells.length) sum += length;
  double edge = 0;
  for (double& length : cells.length) {
    length *= 4 / sum;
    cells.position.push_back(edge + length / 2);
    cells.mass.push_back(density(cells.position.back()) * length);
    edge += length;
  }
  cells.velocity.assign(count, 0);
  cells.length_rate.assign(count, 0);
  return cells;
}

/// The same with the linear velocity  u = offset + slope x.
inline SheetCells moving_cells(const Profile& density, double gravity, double offset,
                               double slope) {
  SheetCells cells = cells_at_rest(density, gravity);
  for (std::size_t i = 0; i < cells.position.size(); ++i) {
    cells.velocity[i] = offset + slope * cells.position[i];
    cells.length_rate[i] = slope * cells.length[i];
  }
  return cells;
}

inline double slab(double x) { return x >= 1.4 && x < 3 ? 1.025 : 0.025; }
inline double ramp(double x) { return 0.2 + 0.3 * x; }

}  // namespace mote::test
