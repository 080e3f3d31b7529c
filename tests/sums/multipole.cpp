#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "mote/sums/biot_savart.hpp"
#include "mote/sums/gravity.hpp"
#include "sums/clouds.hpp"

namespace mote::test {
namespace {

using Numbers = std::vector<double>;

/// The largest difference of vectors of `components` numbers over the largest of them.
double relative_difference(const Numbers& values, const Numbers& exact, std::size_t components) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < exact.size(); i += components) {
    double off = 0, size = 0;
    for (std::size_t c = i; c < i + components; ++c) {
      off = std::hypot(off, values[c] - exact[c]);
      size = std::hypot(size, exact[c]);
    }
    difference = std::max(difference, off);
    largest = std::max(largest, size);
  }
  return difference / largest;
}

/// What the sums give at the sources, or at other targets: potential and gradient of masses,
/// velocity and its gradient of vortices.
struct Fields {
  Numbers potential, gradient, velocity, velocity_gradient;
  bool operator==(const Fields&) const = default;
};

template <int D>
struct SumCase {
  static constexpr std::size_t components = D == 2 ? 1 : 3;

  Numbers positions, targets, mass, circulation;
  std::string core = "point";
  double core_size = 0;

  explicit SumCase(const PointCloud& cloud) : positions(cloud.positions) {
    Draws draws(3);
    const std::size_t count = positions.size() / D;
    mass = draws.uniform(count, 0, 1);
    circulation = draws.uniform(components * count, -1, 1);
  }

  Fields fields(const SumSettings& settings) const {
    const std::size_t count = (targets.empty() ? positions : targets).size() / D;
    Fields fields{Numbers(count), Numbers(D * count), Numbers(D * count), Numbers(D * D * count)};
    Gravity<D> gravity(settings, core);
    BiotSavart<D> vortices(settings, core);
    const Sources<D> masses{positions, mass, core_size}, blobs{positions, circulation, core_size};
    const GravityField of_masses{fields.potential, fields.gradient};
    const VelocityField of_vortices{fields.velocity, fields.velocity_gradient};
    if (targets.empty()) {
      gravity.at_sources(masses, of_masses);
      vortices.at_sources(blobs, of_vortices);
    } else {
      gravity.at(targets, masses, of_masses);
      vortices.at(targets, blobs, of_vortices);
    }
    return fields;
  }

  /// The largest error of the multipole method against the direct sum.
  double error(double tolerance) const {
    const Fields exact = fields({SumMethod::direct, 0});
    const Fields found = fields({SumMethod::multipole, tolerance});
    return std::max({relative_difference(found.potential, exact.potential, 1),
                     relative_difference(found.gradient, exact.gradient, D),
                     relative_difference(found.velocity, exact.velocity, D),
                     relative_difference(found.velocity_gradient, exact.velocity_gradient, D * D)});
  }
};

template <class T>
class Multipoles : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Multipoles, Dimensions);

TYPED_TEST(Multipoles, KeepTheirToleranceForPointsOfAnyKind) {
  for (const PointCloud& cloud : clouds<TypeParam::value>(some_points)) {
    SCOPED_TRACE(cloud.name);
    const SumCase<TypeParam::value> sum(cloud);
    for (const double tolerance : {1e-3, 1e-6, 1e-10, 1e-13}) {
      const double rounding = 3e-15;  // of the direct sums
      EXPECT_LE(sum.error(tolerance), tolerance + rounding) << tolerance;
    }
  }
}

TYPED_TEST(Multipoles, KeepTheirToleranceForBlobs) {
  for (const std::string core : {"gauss", "algebraic.2", "algebraic.6"}) {
    SCOPED_TRACE(core);
    SumCase<TypeParam::value> sum(clouds<TypeParam::value>(some_points).front());
    sum.core = core;
    sum.core_size = 0.03;
    for (const double tolerance : {1e-3, 1e-6})
      EXPECT_LE(sum.error(tolerance), tolerance) << tolerance;
  }
}

TYPED_TEST(Multipoles, KeepTheirToleranceAtOtherTargets) {
  const auto kinds = clouds<TypeParam::value>(some_points);
  SumCase<TypeParam::value> sum(kinds.front());
  for (const std::size_t kind : {2u, 4u, 5u}) {
    SCOPED_TRACE(kinds[kind].name);
    sum.targets = kinds[kind].positions;
    EXPECT_LE(sum.error(1e-7), 1e-7);
  }
}

TYPED_TEST(Multipoles, OfALowToleranceMissManyDigits) {
  const SumCase<TypeParam::value> sum(clouds<TypeParam::value>(some_points).front());
  EXPECT_GT(sum.error(1e-3), 1e-9);
}

TYPED_TEST(Multipoles, HaveTheSameBitsForAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  for (const PointCloud& cloud : clouds<TypeParam::value>(12000)) {
    SCOPED_TRACE(cloud.name);
    const SumCase<TypeParam::value> sum(cloud);
    omp_set_num_threads(1);
    const Fields one = sum.fields({SumMethod::multipole, 1e-4});
    for (const int count : {2, 4}) {
      omp_set_num_threads(count);
      EXPECT_TRUE(one == sum.fields({SumMethod::multipole, 1e-4})) << count;
    }
  }
  omp_set_num_threads(threads);
}

}  // namespace
}  // namespace mote::test
