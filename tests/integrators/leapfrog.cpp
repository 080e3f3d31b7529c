#include <gtest/gtest.h>

#include "mote/integrators/leapfrog_dkd.hpp"
#include "mote/integrators/leapfrog_kdk.hpp"
#include "mote/integrators/velocity_verlet.hpp"
#include "systems.hpp"

namespace mote::test {
namespace {

constexpr int steps = 100;

template <class Method>
Planets& advanced(Planets& planets) {
  Method method;
  for (int k = 0; k < steps; ++k) method.advance_one_step(planets, 0.05 * k, 0.05);
  return planets;
}

TEST(LeapfrogKdk, HasTheBitsOfVelocityVerletWhereBodiesFallFreely) {
  Planets textbook(0.3, 3), verlet(0.3, 3);
  EXPECT_EQ(advanced<LeapfrogKdk>(textbook).error(5), advanced<VelocityVerlet>(verlet).error(5));
  EXPECT_GT(textbook.error(5), 1e-3);
}

TEST(LeapfrogDkd, FormsAccelerationsOnceAStep) {
  Planets planets(0.3), others(0.3);
  EXPECT_EQ(advanced<LeapfrogDkd>(planets).evaluations, steps);
  EXPECT_EQ(advanced<LeapfrogKdk>(others).evaluations, 2 * steps);
}

/// A density that is carried along, drho/dt = -rho, beside nothing else.
class CarriedDensity final : public System {
 public:
  std::span<const Evolving> drifted() override { return {}; }
  std::span<const Evolving> kicked() override { return {}; }
  bool drifts_freely() const override { return false; }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {}
};

TEST(Leapfrogs, NeedDriftRatesThatFollowFromVelocities) {
  CarriedDensity density;
  Planets planets(0.3);
  EXPECT_EQ(LeapfrogKdk().missing_in(density), "drift rates that follow from velocities alone");
  EXPECT_EQ(LeapfrogDkd().missing_in(density), "drift rates that follow from velocities alone");
  EXPECT_EQ(LeapfrogKdk().missing_in(planets), "");
  EXPECT_EQ(LeapfrogDkd().missing_in(planets), "");
}

}  // namespace
}  // namespace mote::test
