#include "mote/xivas/box_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mote/particles/failure.hpp"
#include "mote/particles/random.hpp"

namespace mote {
namespace {

/// Spacings along every axis, as numbers of any size.
template <int D>
Vec<D> spacings_along(const Vec<D>& lower, const Vec<D>& upper, double spacing) {
  return ((upper - lower) / spacing).array().round().max(1);
}

}  // namespace

template <int D>
double count_of_points_in_box(const Vec<D>& lower, const Vec<D>& upper, double spacing) {
  return (spacings_along<D>(lower, upper, spacing).array() + 1).prod();
}

template <int D>
std::vector<double> points_in_box(const Vec<D>& lower, const Vec<D>& upper, const BoxPoints& of) {
  const double count = count_of_points_in_box<D>(lower, upper, of.spacing);
  if (!is_countable_mesh<D>(count)) throw InputError("a mesh cannot have so many points");
  const Vec<D> spacings = spacings_along<D>(lower, upper, of.spacing);
  std::array<Index, D> cells;
  for (std::size_t d = 0; d < D; ++d)
    cells[d] = static_cast<Index>(spacings[static_cast<Eigen::Index>(d)]);
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

template double count_of_points_in_box<2>(const Vec<2>&, const Vec<2>&, double);
template double count_of_points_in_box<3>(const Vec<3>&, const Vec<3>&, double);
template std::vector<double> points_in_box<2>(const Vec<2>&, const Vec<2>&, const BoxPoints&);
template std::vector<double> points_in_box<3>(const Vec<3>&, const Vec<3>&, const BoxPoints&);

}  // namespace mote
