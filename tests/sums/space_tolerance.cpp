// Sums in space against direct ones where the errors of many pairs of nodes are likely to add up,
// or where the largest values are far from the usual ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mote/sums/gravity.hpp"
#include "sums/clouds.hpp"

namespace mote::test {
namespace {

using Numbers = std::vector<double>;
using Place = std::array<double, 3>;

Place direction(Draws& draws) {
  const double z = draws.uniform(-1, 1), angle = draws.uniform(0, 2 * std::numbers::pi);
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

Place at_radius(double radius, Draws& draws) {
  Place place = direction(draws);
  for (double& x : place) x *= radius;
  return place;
}

/// Shells within shells, spheres of a law of density that grows inwards, a lattice of two points a
/// cell, and a heap within a sparse cube.
std::vector<PointCloud> symmetric_clouds(std::size_t count) {
  Draws draws(8);
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count) / 2)));
  return {cloud_of<3>("shells", count,
                      [&](std::size_t k) { return at_radius(k % 2 ? 1 : 1e-3, draws); }),
          cloud_of<3>("Plummer", count,
                      [&](std::size_t) {
                        const double inner = draws.uniform(1e-6, 1);
                        return at_radius(1 / std::sqrt(std::pow(inner, -2.0 / 3) - 1), draws);
                      }),
          cloud_of<3>("isothermal", count,
                      [&](std::size_t) { return at_radius(draws.uniform(0, 1), draws); }),
          cloud_of<3>(
              "alike at all scales", count,
              [&](std::size_t) { return at_radius(std::pow(10, draws.uniform(-8, 0)), draws); }),
          cloud_of<3>("lattice of two", count,
                      [&](std::size_t k) {
                        Place place;
                        place.fill(k % 2 ? 0.5 : 0);
                        k /= 2;
                        for (double& x : place) {
                          x += static_cast<double>(k % side);
                          k /= side;
                        }
                        return place;
                      }),
          cloud_of<3>("heap", count, [&](std::size_t k) {
            return at_radius(k % 10 ? 1e-4 * draws.uniform(0, 1) : draws.uniform(0, 1), draws);
          })};
}

std::vector<Numbers> masses_of_kinds(std::size_t count) {
  Draws draws(9);
  Numbers orders(count);
  for (double& mass : orders) mass = std::pow(10, draws.uniform(-9, 0));
  return {Numbers(count, 1), draws.uniform(count, -1, 1), orders};
}

struct Field {
  Numbers potential, gradient;

  Field(const PointCloud& cloud, const Numbers& mass, const SumSettings& settings)
      : potential(mass.size()), gradient(3 * mass.size()) {
    Gravity<3>(settings).at_sources({cloud.positions, mass}, {potential, gradient});
  }
};

/// The larger of the errors of potential and gradient.
double error(const Field& found, const Field& exact) {
  double largest[] = {0, 0}, off[] = {0, 0};
  for (std::size_t i = 0; i < exact.potential.size(); ++i) {
    largest[0] = std::max(largest[0], std::abs(exact.potential[i]));
    off[0] = std::max(off[0], std::abs(found.potential[i] - exact.potential[i]));
    double size = 0, difference = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      size = std::hypot(size, exact.gradient[c]);
      difference = std::hypot(difference, found.gradient[c] - exact.gradient[c]);
    }
    largest[1] = std::max(largest[1], size);
    off[1] = std::max(off[1], difference);
  }
  return std::max(off[0] / largest[0], off[1] / largest[1]);
}

/// The largest error over the tolerance that was promised, if `asked` times that is asked for.
double worst(double tolerance, double asked) {
  constexpr double rounding = 3e-15;
  constexpr std::size_t count = some_points * 2 / 3;
  double worst = 0;
  for (const PointCloud& cloud : symmetric_clouds(count))
    for (const Numbers& mass : masses_of_kinds(count)) {
      const Field exact(cloud, mass, {SumMethod::direct, 0});
      const Field found(cloud, mass, {SumMethod::multipole, asked * tolerance});
      worst = std::max(worst, std::max(0.0, error(found, exact) - rounding) / tolerance);
    }
  return worst;
}

class SpaceTolerances : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Tolerances, SpaceTolerances, testing::Values(1e-3, 1e-6, 1e-9, 1e-12));

TEST_P(SpaceTolerances, AreKeptWhereErrorsHaveACommonSign) { EXPECT_LE(worst(GetParam(), 1), 1); }

TEST(SpaceTolerance, IsNotKeptByFarTooLargeAShareOfAPair) {
  for (const double tolerance : {1e-6, 1e-11}) EXPECT_GT(worst(tolerance, 50), 1) << tolerance;
}

}  // namespace
}  // namespace mote::test
