#include "mote/exact/taylor_green.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "flow_residual.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

constexpr VortexLattice lattice{1.5, 2 * pi, 0.3, -0.8, 2, 0.01, 7};
constexpr FlowConstants water{.density = 2, .viscosity = 0.01};
// Central differences of length 1e-4 are exact to (k h)^2/6 = 7e-8, and to rounding over h^2.
constexpr double tolerance = 1e-6;

TEST(TaylorGreen, SolvesTheEquationsOfAnIncompressibleFlow) {
  for (const double t : {0.1, 1.3})
    for (const double x : {0.11, 0.57})
      EXPECT_LT(flow_residual(TaylorGreen(lattice), water, x, 0.23, t), tolerance) << x << t;
}

TEST(TaylorGreen, CheckNoticesAnotherViscosityAndAnotherPressure) {
  VortexLattice wrong = lattice;
  wrong.viscosity = 0.0101;
  EXPECT_GT(flow_residual(TaylorGreen(wrong), water, 0.11, 0.23, 0.1), 10 * tolerance);
  wrong = lattice;
  wrong.density = 2.001;
  EXPECT_GT(flow_residual(TaylorGreen(wrong), water, 0.11, 0.23, 0.1), 10 * tolerance);
}

TEST(TaylorGreen, DecaysAsTheReferenceValuesDo) {
  VortexLattice box{1, 2 * pi};
  const std::array<double, 3> crest{0.25, 0, 0};
  for (const auto& [reynolds, time, factor] :
       {std::array{100.0, 1.0, 0.4540}, {100.0, 5.0, 0.0193}, {1000.0, 2.0, 0.8539}}) {
    box.viscosity = 1 / reynolds;
    EXPECT_NEAR(TaylorGreen(box).at(crest, time).velocity[0], factor, 5e-5);
  }
}

}  // namespace
}  // namespace mote::test
