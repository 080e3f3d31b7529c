#include <algorithm>

#include "mote/sums/harmonic_expansion.hpp"
#include "mote/sums/solid_harmonics.hpp"

namespace mote {
namespace {

/// Numbers from a column; beyond its end there are zeros.
Lanes lanes_from(const double* column, std::size_t count) {
  if (count >= lane_count) return Lanes(column, std::experimental::element_aligned);
  return Lanes([&](auto lane) { return lane < count ? column[lane] : 0; });
}

/// sums += strength times the harmonics of one order, of all degrees.
void add_order(int degree, const SolidHarmonics& harmonics, const Lanes& strength, Lanes* sums) {
  const int m = harmonics.order();
  const Lanes even = strength * harmonics.cosine(), odd = strength * harmonics.sine();
  for (int n = m; n <= degree; ++n) {
    sums[cosine_place(n, m)] += harmonics.of_degree(n) * even;
    if (m > 0) sums[sine_place(n, m)] += harmonics.of_degree(n) * odd;
  }
}

}  // namespace

void HarmonicExpansion::add_points(const PointColumns& points, const NodeBall& ball,
                                   double* multipole) {
  clear_sums(degree_);
  const double radius = ball.radius > 0 ? ball.radius : 1;  // at radius 0 all points are at 0
  for (std::size_t first = 0; first < points.count; first += lane_count) {
    const std::size_t count = std::min(lane_count, points.count - first);
    std::array<Lanes, 3> x;
    for (std::size_t d = 0; d < 3; ++d)
      x[d] = (lanes_from(points.position[d] + first, count) - ball.centre[d]) / radius;
    for (std::size_t lane = count; lane < lane_count; ++lane)
      for (std::size_t d = 0; d < 3; ++d) x[d][lane] = 0;
    SolidHarmonics harmonics(degree_, x);
    for (int m = 0; m <= degree_; ++m) {
      harmonics.prepare_order(m);
      for (int c = 0; c < components_; ++c)
        add_order(degree_, harmonics,
                  lanes_from(points.strengths[static_cast<std::size_t>(c)] + first, count),
                  sums_.data() + place_of(c));
    }
  }
  add_sums(degree_, multipole);
}

}  // namespace mote
