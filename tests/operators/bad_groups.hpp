#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "mote/particles/failure.hpp"
#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace mote::test {

/// The places of a group of points that is to have a neighbourhood of its own.
template <int D>
using Places = std::vector<Vec<D>>;

/// `count` places at this distance on a line that is parallel to no axis.
template <int D>
Places<D> places_on_a_line(int count, double distance) {
  Places<D> places;
  for (int k = 0; k < count; ++k) {
    Vec<D> direction;
    for (int d = 0; d < D; ++d) direction[d] = 1 + 0.5 * d;
    places.push_back(k * distance * direction.normalized());
  }
  return places;
}

/// A corner and the ends of D edges that are not at right angles.
template <int D>
Places<D> places_of_a_simplex() {
  Places<D> places{Vec<D>::Zero()};
  for (int d = 0; d < D; ++d) places.push_back(Vec<D>::Unit(d) + Vec<D>::Constant(0.1 * (d + 1)));
  return places;
}

/// side^2 places at this distance on a tilted plane.
inline Places<3> places_on_a_plane(int side, double distance) {
  Places<3> places;
  const Vec<3> a = Vec<3>(1, 0.5, -0.2).normalized();
  const Vec<3> b = (Vec<3>(0, 1, 1) - a.dot(Vec<3>(0, 1, 1)) * a).normalized();
  for (int k = 0; k < side * side; ++k) places.push_back(distance * (k % side * a + k / side * b));
  return places;
}

inline constexpr double far = 30;  ///< how far the group is from the cloud
inline constexpr Index first_of_group = 3;

/// A healthy cloud of receivers and a group far from it, whose points have the numbers 3, 6, 9, ...
template <int D>
Points<D> cloud_with_group(Index side, const Places<D>& group) {
  auto points = jittered_cloud<D>({.side = side, .jitter = 0.05, .variation = 0});
  const Index healthy = points.size(), count = healthy + static_cast<Index>(group.size());
  points.resize(count, count);
  for (std::size_t k = 0; k < group.size(); ++k) {
    const Index place = healthy + static_cast<Index>(k);
    const auto number = first_of_group * static_cast<Index>(k + 1);
    points.mass[place] = points.density[place] = points.length[place] = 1;
    Vec<D>::Map(&points.position[place * D]) = group[k] - Vec<D>::Constant(far);
    for (int d = 0; d < D && number < place; ++d)
      std::swap(points.position[place * D + d], points.position[number * D + d]);
  }
  return points;
}

/// Expects that an operator refuses these points because of this particle, with these words.
template <int D, class Operator>
void expect_refusal(Operator op, const Points<D>& points, Index particle, const std::string& what,
                    const std::string& cause) {
  try {
    op.prepare(points, brute_force(points, op.neighbour_rule()));
    FAIL() << "the operator accepts these points";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.particles(), testing::ElementsAre(particle));
    EXPECT_THAT(failure.what(),
                testing::StartsWith("particle " + std::to_string(particle) + " has "));
    EXPECT_THAT(failure.what(), testing::HasSubstr(what));
    EXPECT_THAT(failure.cause(), testing::HasSubstr(cause));
  }
}

}  // namespace mote::test
