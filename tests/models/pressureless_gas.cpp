#include "mote/models/pressureless_gas.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "mote/integrators/all.hpp"
#include "mote/particles/failure.hpp"
#include "support/line_gas.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

/// All fields after 200 steps with sph.gauss and density by the continuity equation; nothing if the
/// method needs what this gas lacks.
template <class Method>
std::vector<std::vector<double>> state_with_threads(int threads) {
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(threads);
  LineGas gas = trapezoid();
  gas.velocity = [](double x) { return 0.05 * std::sin(x); };
  const PressurelessGasOptions options{
      .gravity = gas.gravity, .viscosity = 1e-3, .density = DensityForm::continuity};
  PressurelessGas model = make_gas<Random>(gas, options, 101, sph_gauss(), 3);
  Method method;
  if (!method.missing_in(model).empty()) return {};
  run(model, method, 0.2, 200);
  omp_set_num_threads(threads_before);
  std::vector<std::vector<double>> state;
  for (const Field& field : model.cloud().fields()) state.push_back(field.values);
  return state;
}

TEST(PressurelessGas, GivesTheSameBitsAtAnyNumberOfThreads) {
  for_each_type(Integrators{}, []<class Method>() {
    const auto state = state_with_threads<Method>(1);
    EXPECT_EQ(state_with_threads<Method>(2), state) << Method::name;
    EXPECT_EQ(state_with_threads<Method>(4), state) << Method::name;
  });
  EXPECT_NE(state_with_threads<SymplecticEuler>(1), state_with_threads<ForwardEuler>(1));
}

/// Drift of a conserved quantity of a gas on a random layout, relative to its scale; 0 if the
/// integrator needs what this gas lacks.
struct Drifts {
  double mass, momentum, energy;
};

Drifts drifts(Integrator& integrator, int steps) {
  Draws draws(51);
  std::vector<double> wave = draws.uniform(6, -0.02, 0.02);
  LineGas gas = rectangle();
  gas.velocity = [wave](double x) {
    double u = 0.01;
    for (std::size_t k = 0; k < wave.size(); ++k) u += wave[k] * std::sin((k + 1.0) * x);
    return u;
  };
  PressurelessGas model = make_gas<Random>(gas, {.gravity = gas.gravity}, 200, sph_gauss(), 7);
  if (!integrator.missing_in(model).empty()) return {};
  const auto start = model.conserved();
  run(model, integrator, 5, steps);
  model.inspect();
  const auto end = model.conserved();
  const auto drift = [&](std::size_t k) {
    return std::abs(end[k].value - start[k].value) / std::max(start[k].scale, end[k].scale);
  };
  EXPECT_EQ(start[0].name + start[1].name + start[2].name, "massmomentumenergy");
  return {drift(0), drift(1), drift(2)};
}

TEST(PressurelessGas, KeepsMassMomentumAndEnergyToRoundingWithDirectSheets) {
  VelocityVerlet verlet;
  const Drifts found = drifts(verlet, 5000);
  EXPECT_EQ(found.mass, 0);
  EXPECT_LE(found.momentum, 1e-14);
  EXPECT_LE(found.energy, 1e-14);
}

TEST(PressurelessGas, KeepsMomentumToRoundingWithEveryIntegrator) {
  for_each_type(Integrators{}, []<class Method>() {
    Method method;
    EXPECT_LE(drifts(method, 500).momentum, 1e-14) << Method::name;
  });
}

TEST(PressurelessGas, EnergyDriftIsNoticedWithAMethodOfFirstOrder) {
  ForwardEuler euler;
  EXPECT_GT(drifts(euler, 5000).energy, 1e-9);
}

TEST(PressurelessGas, RefusesMassOverVolumeForPointsThatStandStill) {
  const PressurelessGasOptions options{.density = DensityForm::mass_over_volume,
                                       .frame = FrameChoice::eulerian};
  EXPECT_THROW(make_gas(trapezoid(), options, 41), InputError);
}

TEST(PressurelessGas, RefusesAVacuumAtTheStart) {
  LineGas gas = trapezoid();
  gas.density = [](double x) { return x - 2; };
  EXPECT_THROW(make_gas(gas, {}, 41), InputError);
}

TEST(PressurelessGas, InspectNamesParticlesThatCrossed) {
  PressurelessGas model = make_gas(trapezoid(), {.gravity = 0.0015}, 41);
  EXPECT_NO_THROW(model.inspect());
  std::swap(model.cloud().position()[5], model.cloud().position()[6]);
  try {
    model.inspect();
    FAIL() << "particles 5 and 6 stand in the wrong order";
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.particles(), (std::vector<Index>{5, 6}));
  }
}

TEST(PressurelessGas, InspectNamesAParticleThatIsNoNumber) {
  PressurelessGas model = make_gas(trapezoid(), {.gravity = 0.0015}, 41);
  model.cloud().values("velocity")[8] = NAN;
  try {
    model.inspect();
    FAIL() << "a velocity is not a number";
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.particles(), std::vector<Index>{8});
  }
}

TEST(PressurelessGas, InspectNamesACollapsedCell) {
  PressurelessGas model = make_gas(trapezoid(), {.gravity = 0.0015}, 41);
  model.cloud().values("length")[9] = 0;
  try {
    model.inspect();
    FAIL() << "a cell has no length";
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.particles(), std::vector<Index>{9});
  }
}

}  // namespace
}  // namespace mote::test
