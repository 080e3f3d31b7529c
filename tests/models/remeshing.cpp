#include "mote/models/remeshing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mote/particles/random.hpp"

namespace mote::test {
namespace {

VortexList<2> scattered(std::size_t count) {
  VortexList<2> vortices;
  for (std::size_t i = 0; i < count; ++i) {
    const double place[] = {3 * uniform_random(1, 3 * i), 2 * uniform_random(1, 3 * i + 1)};
    const double strength = 2 * uniform_random(1, 3 * i + 2) - 0.5;
    vortices.add(place, {&strength, 1});
  }
  return vortices;
}

/// Sums of Gamma, Gamma x, Gamma y and Gamma r^2.
std::array<double, 4> sums(const VortexList<2>& vortices) {
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < vortices.count(); ++i) {
    const double x = vortices.position[2 * i], y = vortices.position[2 * i + 1];
    const double factors[] = {1, x, y, x * x + y * y};
    for (std::size_t k = 0; k < 4; ++k) sums[k] += vortices.circulation[i] * factors[k];
  }
  return sums;
}

constexpr VortexLatticeOptions lattice{.spacing = 0.1, .lower = {-0.03, 0.02, 0}};

TEST(Remeshing, KeepsCirculationAndBothImpulses) {
  const VortexList<2> vortices = scattered(300);
  const auto before = sums(vortices), after = sums(remeshed(vortices, lattice));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(after[k] / before[k], 1, 1e-13) << k;
}

TEST(Remeshing, GivesBackWhatFallsBelowTheThreshold) {
  VortexLatticeOptions coarse = lattice;
  coarse.threshold = 0.05;
  const VortexList<2> vortices = scattered(300);
  RemeshingLoss loss;
  const VortexList<2> kept = remeshed(vortices, coarse, &loss);
  EXPECT_GT(loss.dropped, 1e-3);
  EXPECT_LT(kept.count(), remeshed(vortices, lattice).count());
  const auto before = sums(vortices), after = sums(kept);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(after[k] / before[k], 1, 1e-13) << k;
}

TEST(Remeshing, LeavesAVortexOnANodeAlone) {
  const double place[] = {-0.03 + 4.5 * 0.1, 0.02 + 2.5 * 0.1}, strength = 2;
  VortexList<2> one;
  one.add(place, {&strength, 1});
  VortexLatticeOptions coarse = lattice;
  coarse.threshold = 1e-10;
  const VortexList<2> after = remeshed(one, coarse);
  ASSERT_EQ(after.count(), 1u);
  EXPECT_NEAR(after.circulation[0], 2, 1e-13);
  EXPECT_NEAR(after.position[0], place[0], 1e-14);
}

/// A smooth vorticity on a shifted lattice comes out as it is at the nodes, with an error of the
/// order 3.
double smooth_error(double spacing) {
  const auto field = [](double x, double y) { return std::exp(-(x * x + 2 * y * y)); };
  VortexList<2> vortices;
  for (int i = -60; i < 60; ++i)
    for (int j = -60; j < 60; ++j) {
      const double place[] = {(i + 0.2) * spacing, (j + 0.37) * spacing};
      if (std::hypot(place[0], place[1]) > 3) continue;
      const double strength = field(place[0], place[1]);
      vortices.add(place, {&strength, 1});
    }
  const VortexList<2> after = remeshed(vortices, {.spacing = spacing});
  double worst = 0;
  for (std::size_t i = 0; i < after.count(); ++i) {
    const double x = after.position[2 * i], y = after.position[2 * i + 1];
    if (std::hypot(x, y) < 2) worst = std::max(worst, std::abs(after.circulation[i] - field(x, y)));
  }
  return worst;
}

TEST(Remeshing, IsOfTheThirdOrder) {
  const double order = std::log2(smooth_error(0.1) / smooth_error(0.05));
  EXPECT_GT(order, 2.8);
  EXPECT_LT(order, 3.3);
  EXPECT_LT(smooth_error(0.05), 2e-4);
}

TEST(Remeshing, WrapsInABox) {
  VortexLatticeOptions box{.spacing = 0.1, .cells = {10, 20, 0}};
  const double place[] = {0.01, 1.99}, strength = 1;
  VortexList<2> one;
  one.add(place, {&strength, 1});
  const VortexList<2> after = remeshed(one, box);
  double sum = 0;
  for (std::size_t i = 0; i < after.count(); ++i) {
    sum += after.circulation[i];
    EXPECT_TRUE(after.position[2 * i] > 0 && after.position[2 * i] < 1);
    EXPECT_TRUE(after.position[2 * i + 1] > 0 && after.position[2 * i + 1] < 2);
  }
  EXPECT_NEAR(sum, 1, 1e-14);
}

/// And a Gauss function widens: so the checks of second moments above can fail.
TEST(SpreadingOnALattice, AddsItsVarianceAlongBothAxes) {
  const VortexList<2> vortices = scattered(100);
  const double deviation = 0.15;
  const auto before = sums(vortices), after = sums(spread_on_lattice(vortices, lattice, deviation));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k] / before[k], 1, 1e-12) << k;
  EXPECT_NEAR((after[3] - before[3]) / (2 * deviation * deviation * before[0]), 1, 1e-10);
}

}  // namespace
}  // namespace mote::test
