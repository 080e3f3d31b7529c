#include "mote/xivas/box_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mote/particles/random.hpp"

namespace mote {

template <int D>
std::vector<double> points_in_box(const Vec<D>& lower, const Vec<D>& upper, const BoxPoints& of) {
  std::array<Index, D> cells;
  for (int d = 0; d < D; ++d)
    cells[static_cast<std::size_t>(d)] =
        std::max(1, static_cast<Index>(std::lround((upper[d] - lower[d]) / of.spacing)));
  std::vector<double> points;
  std::array<Index, D> at{};
  for (std::size_t d = 0; d < D;) {
    const bool inside =
        std::ranges::equal(at, cells, [](Index a, Index n) { return 0 < a && a < n; });
    for (std::size_t k = 0; k < D; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double move = inside ? of.jitter * (2 * uniform_random(of.seed, points.size()) - 1) : 0;
      const double part = (at[k] + move) / cells[k];
      points.push_back((1 - part) * lower[axis] + part * upper[axis]);
    }
    for (d = 0; d < D && ++at[d] > cells[d]; ++d) at[d] = 0;
  }
  return points;
}

template std::vector<double> points_in_box<2>(const Vec<2>&, const Vec<2>&, const BoxPoints&);
template std::vector<double> points_in_box<3>(const Vec<3>&, const Vec<3>&, const BoxPoints&);

}  // namespace mote
