#include <algorithm>

#include "mote/sums/harmonic_expansion.hpp"
#include "mote/sums/solid_harmonics.hpp"

namespace mote {
namespace {

/// Numbers from a column; beyond its end stands `beyond`.
Lanes lanes_from(const double* column, std::size_t count, double beyond) {
  if (count >= lane_count) return Lanes(column, std::experimental::element_aligned);
  return Lanes([&](auto lane) { return lane < count ? column[lane] : beyond; });
}

/// Places of eight points in units of the radius. Where that is 0, all points are at the centre.
std::array<Lanes, 3> places(const PointColumns& points, std::size_t first, std::size_t count,
                            const NodeBall& ball) {
  const double radius = ball.radius > 0 ? ball.radius : 1;
  std::array<Lanes, 3> result;
  for (std::size_t d = 0; d < 3; ++d)
    result[d] =
        (lanes_from(points.position[d] + first, count, ball.centre[d]) - ball.centre[d]) / radius;
  return result;
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
  for (std::size_t first = 0; first < points.count; first += lane_count) {
    const std::size_t count = std::min(lane_count, points.count - first);
    for (std::size_t c = 0; c < strengths_.size(); ++c)
      strengths_[c] = lanes_from(points.strengths[c] + first, count, 0);
    SolidHarmonics harmonics(degree_, places(points, first, count, ball));
    for (int m = 0; m <= degree_; ++m) {
      harmonics.prepare_order(m);
      for (std::size_t c = 0; c < strengths_.size(); ++c)
        add_order(degree_, harmonics, strengths_[c], sums_.data() + place_of(static_cast<int>(c)));
    }
  }
  add_sums(degree_, multipole);
}

}  // namespace mote
