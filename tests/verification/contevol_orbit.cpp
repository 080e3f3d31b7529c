// The orbit of eccentricity 63/64 of the ContEvol paper, section 3.4, against the exact one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mote/exact/kepler_orbit.hpp"
#include "mote/integrators/conservation_correction.hpp"
#include "support/few_bodies.hpp"

namespace mote::test {
namespace {

const double pericentre_speed = std::sqrt(127.0) / 4;

/// A test particle at the pericentre of an orbit about a mass 1: semi-major axis 16.
struct EccentricOrbit : FewBodies<3> {
  EccentricOrbit()
      : FewBodies<3>({1, 0}, {0, 0, 0, 0.25, 0, 0}, {0, 0, 0, 0, pericentre_speed, 0}) {}
};

/// The largest error of the position up to t = 432, relative to the distance.
template <class Method>
double largest_error(double step) {
  const KeplerOrbit exact(
      {.gravitational_parameter = 1, .semi_major_axis = 16, .eccentricity = 63.0 / 64});
  EccentricOrbit system;
  Method method;
  double largest = 0;
  for (int k = 1; k * step <= 432; ++k) {
    method.advance_one_step(system, (k - 1) * step, step);
    const auto [x, y] = exact.at(k * step).position;
    const double error = std::hypot(system.position[3] - x, system.position[4] - y);
    largest = std::max(largest, error / std::hypot(x, y));
  }
  return largest;
}

/// The correction with the sign of the coordinate y for that of the radial velocity, as section 3.4
/// does it.
struct CorrectedBySignOfY : ContEvol1 {
  void advance_one_step(System& system, double time, double step) override {
    ContEvol1::advance_one_step(system, time, step);
    const auto place = system.drifted().front().value.last(3);
    const auto velocity = system.kicked().front().value.last(3);
    const double x = place[0], y = place[1], r = std::hypot(x, y);
    const double L = pericentre_speed / 4;
    const double root = std::copysign(std::sqrt(std::max(2 * r - r * r / 16 - L * L, 0.0)), y);
    velocity[0] = (-y * L + x * root) / (r * r);
    velocity[1] = (x * L + y * root) / (r * r);
  }
};

TEST(ContEvolOrbit, IsFollowedWithLongSteps) {
  EXPECT_NEAR(largest_error<ContEvol1Corrected>(1.0 / 16), 1.36e-2, 1e-4);
  EXPECT_NEAR(largest_error<ContEvol2IndirectCorrected>(1.0 / 16), 1.25e-4, 1e-6);
}

TEST(ContEvolOrbit, IsFollowedToThePrecisionOfTheCorrection) {
  EXPECT_NEAR(largest_error<ContEvol1Corrected>(1.0 / 256), 3.44e-9, 0.05e-9);
  EXPECT_LE(largest_error<ContEvol2IndirectCorrected>(1.0 / 256), 1e-9);
}

TEST(ContEvolOrbit, IsLostWithTheSignOfACoordinate) {
  EXPECT_GT(largest_error<CorrectedBySignOfY>(1.0 / 16), 4.5);
}

TEST(ContEvolOrbit, IsLostWithoutCorrection) { EXPECT_GT(largest_error<ContEvol1>(1.0 / 16), 100); }

}  // namespace
}  // namespace mote::test
