#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "mote/sums/harmonic_expansion.hpp"
#include "support/random.hpp"

namespace mote::test {

/// Points in a ball with three random strengths each.
struct HarmonicCloud {
  std::array<std::vector<double>, 3> position, strength;

  HarmonicCloud(std::size_t count, const NodeBall& ball, Draws draws) {
    while (position[0].size() < count) {
      Vector3 x;
      for (double& component : x) component = draws.uniform(-1, 1);
      if (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] > 1) continue;
      for (std::size_t d = 0; d < 3; ++d) {
        position[d].push_back(ball.centre[d] + ball.radius * x[d]);
        strength[d].push_back(draws.uniform(-1, 1));
      }
    }
  }

  std::size_t size() const { return position[0].size(); }

  /// The multipole expansion of the first `components` strengths from `first` on.
  std::vector<double> multipole(HarmonicExpansion& expansion, const NodeBall& ball,
                                std::size_t first = 0) const {
    std::vector<const double*> columns;
    for (std::size_t c = 0; c < static_cast<std::size_t>(expansion.components()); ++c)
      columns.push_back(strength[first + c].data());
    std::vector<double> result(expansion.coefficients());
    expansion.add_points(
        {{position[0].data(), position[1].data(), position[2].data()}, columns, size()}, ball,
        result.data());
    return result;
  }

  /// The first eight points.
  std::array<Lanes, 3> lanes() const {
    std::array<Lanes, 3> result;
    for (std::size_t d = 0; d < 3; ++d)
      result[d] = Lanes(position[d].data(), std::experimental::element_aligned);
    return result;
  }

  /// Potential, gradient (3), curl (3) and gradient of the curl (9) at a place: of the first
  /// strength, and of the strengths as a vector.
  std::array<long double, 16> sums_at(const Vector3& place) const {
    std::array<long double, 16> sums{};
    for (std::size_t j = 0; j < size(); ++j) add_source(j, place, sums);
    return sums;
  }

 private:
  void add_source(std::size_t j, const Vector3& place, std::array<long double, 16>& sums) const {
    std::array<long double, 3> r;
    for (std::size_t d = 0; d < 3; ++d) r[d] = static_cast<long double>(place[d]) - position[d][j];
    const long double inverse = 1 / std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const long double cube = inverse * inverse * inverse;
    sums[0] += strength[0][j] * inverse;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      const long double alpha_b = strength[b][j], alpha_c = strength[c][j];
      const long double cross = alpha_b * r[c] - alpha_c * r[b];
      sums[1 + a] -= strength[0][j] * r[a] * cube;
      sums[4 + a] += cross * cube;
      sums[7 + 3 * a + c] += alpha_b * cube;
      sums[7 + 3 * a + b] -= alpha_c * cube;
      for (std::size_t d = 0; d < 3; ++d)
        sums[7 + 3 * a + d] -= 3 * cross * r[d] * cube * inverse * inverse;
    }
  }
};

/// The vector from the centre of one ball to that of another.
inline Vector3 displacement(const NodeBall& from, const NodeBall& to) {
  return {to.centre[0] - from.centre[0], to.centre[1] - from.centre[1],
          to.centre[2] - from.centre[2]};
}

}  // namespace mote::test
