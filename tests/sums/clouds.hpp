#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/random.hpp"

namespace mote::test {

/// Points of a test: fewer under the sanitizers, where each pair takes fifty times as long.
#ifdef MOTE_SANITIZED
inline constexpr std::size_t many_points = 2000, some_points = 600;
#else
inline constexpr std::size_t many_points = 15000, some_points = 3000;
#endif

/// Points of a kind that sums over all pairs must cope with, D numbers each.
struct PointCloud {
  std::string name;
  std::vector<double> positions;
};

/// `count` points, each made by `place(k)`.
template <int D, class Place>
PointCloud cloud_of(const std::string& name, std::size_t count, Place place) {
  PointCloud cloud{name, {}};
  for (std::size_t k = 0; k < count; ++k)
    for (const double coordinate : place(k)) cloud.positions.push_back(coordinate);
  return cloud;
}

/// Random, clustered over ten orders of magnitude, nearly coincident pairs, on a line, on a circle
/// (a sphere's great circle), and on a lattice.
template <int D>
std::vector<PointCloud> clouds(std::size_t count) {
  using Place = std::array<double, D>;
  auto draws = std::make_shared<Draws>(17);
  const auto anywhere = [draws] {
    Place place;
    for (double& x : place) x = draws->uniform(-1, 1);
    return place;
  };
  Place last{};
  const auto side =
      static_cast<std::size_t>(std::ceil(std::pow(static_cast<double>(count), 1.0 / D)));
  return {cloud_of<D>("random", count, [&](std::size_t) { return anywhere(); }),
          cloud_of<D>("clustered", count,
                      [&](std::size_t) {
                        const double size = std::pow(10, draws->uniform(-10, 0));
                        Place place = anywhere();
                        for (double& x : place) x = 0.3 + size * x;
                        return place;
                      }),
          cloud_of<D>("near-coincident", count,
                      [&](std::size_t k) {
                        if (k % 2 == 0) return last = anywhere();
                        for (double& x : last) x += 1e-10 * draws->uniform(-1, 1);
                        return last;
                      }),
          cloud_of<D>("collinear", count,
                      [&](std::size_t) {
                        Place place{};
                        place[0] = draws->uniform(-1, 1);
                        return place;
                      }),
          cloud_of<D>("oblique line", count,
                      [&](std::size_t) {
                        Place place;
                        place.fill(draws->uniform(-1, 1));
                        return place;
                      }),
          cloud_of<D>("circle", count,
                      [&](std::size_t) {
                        const double angle = draws->uniform(0, 2 * std::numbers::pi);
                        Place place{};
                        place[0] = std::cos(angle);
                        place[1] = std::sin(angle);
                        return place;
                      }),
          cloud_of<D>("lattice", count, [&](std::size_t k) {
            Place place;
            for (double& x : place) {
              x = static_cast<double>(k % side);
              k /= side;
            }
            return place;
          })};
}

}  // namespace mote::test
