// Vortex rings: their speed, and that two of them pass through each other as thin rings do.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/space_vortex_case.hpp"
#include "support/thin_rings.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

constexpr double core = 0.1;

/// Saffman (1970), for a Gauss function as core.
double theory(double a) { return (std::log(8 / a) - 0.558) / (4 * pi); }

/// Error of the speed of a ring that is given this core, in an eighth of a turn of its middle.
double speed_error(double spacing, double given_core) {
  SpaceVortexCase flow = one_ring(spacing, given_core);
  flow.options.threshold = 1e-3;
  flow.options.overlap = 1.2;
  flow.options.tolerance = 1e-6;
  const auto vortices = make_vortices(flow);
  const double step = 4 * pi * pi * core * core / 16;
  take_steps(*vortices, 2, step);
  return told(*vortices, "centre_z") / (2 * step) / theory(core) - 1;
}

/// Beside the blobs' size there are terms of (a/R)^2, a quarter of a percent (Fukumoto & Moffatt
/// 2000).
TEST(VortexRing, GoesAsFastAsTheorySays) {
  const double coarse = std::abs(speed_error(0.05, core)), fine = std::abs(speed_error(0.04, core));
  EXPECT_LT(fine, 0.01);
  EXPECT_LT(fine, coarse);
}

/// Negative control: a core on top of which the blobs come is too thick.
TEST(VortexRing, GoesSlowerWithBlobsOnTopOfItsCore) {
  const double blobs = 1.2 * 0.05;
  EXPECT_LT(speed_error(0.05, std::sqrt(core * core + 2 * blobs * blobs)), -0.03);
}

/// Where scenarios/vortex/leapfrogging_rings.yaml has its numbers from.
TEST(ThinRings, PassThroughEachOther) {
  ThinRings rings({.outer = 1, .outer_z = 0, .inner = 1, .inner_z = 0.6}, core);
  for (int k = 0; k < 1485; ++k) rings.advance(1e-3);
  const ThinRings::State end = rings.state();
  EXPECT_NEAR(end.outer_z - end.inner_z, 0, 1e-3);
  EXPECT_NEAR(end.outer, 0.7277, 1e-4);
  EXPECT_NEAR(end.inner, 1.2126, 1e-4);
  EXPECT_NEAR(end.outer_z, 1.0035, 1e-3);
}

/// They keep their impulse, the sum of the squares of radii.
TEST(ThinRings, KeepTheirImpulse) {
  ThinRings rings({.outer = 1, .outer_z = 0, .inner = 1.1, .inner_z = 0.6}, core);
  for (int k = 0; k < 3000; ++k) rings.advance(1e-3);
  const ThinRings::State end = rings.state();
  EXPECT_NEAR(end.outer * end.outer + end.inner * end.inner, 2.21, 1e-9);
}

}  // namespace
}  // namespace mote::test
