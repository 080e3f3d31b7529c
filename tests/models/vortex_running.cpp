#include <gtest/gtest.h>

#include <cmath>

#include "support/vortex_case.hpp"

namespace mote::test {
namespace {

VortexCase disordered(Diffusion diffusion = Diffusion::none, double viscosity = 0) {
  VortexCase flow = blobs_of(two_vortices);
  flow.options.diffusion = diffusion;
  flow.options.kinematic_viscosity = viscosity;
  return flow;
}

TEST(Vortex, KeepsCirculationAndImpulsesInDisorder) {
  VortexCase flow = disordered();
  const auto vortices = make_vortices(flow);
  const auto start = vortices->conserved();
  ASSERT_EQ(start.size(), 4u);
  take_steps(*vortices, 20, 0.05);
  EXPECT_LT(largest_drift(start, vortices->conserved()), 1e-9);
  EXPECT_EQ(vortices->conserved()[0].value, start[0].value);
  for (std::size_t k : {1u, 2u})
    EXPECT_NEAR(vortices->conserved()[k].value, start[k].value, 1e-14) << k;
  const double before = told(*make_vortices(flow), "hamiltonian");
  EXPECT_NEAR(told(*vortices, "hamiltonian") / before, 1, 1e-7);
}

/// Remeshing keeps the same; without giving back what the threshold takes it would not.
TEST(Vortex, KeepsThemWhenItIsPutOnALattice) {
  VortexCase flow = disordered();
  flow.options.remesh_every = 4;
  flow.options.threshold = 1e-3;
  const auto vortices = make_vortices(flow);
  const auto start = vortices->conserved();
  take_steps(*vortices, 20, 0.05);
  EXPECT_LT(largest_drift(start, vortices->conserved()), 1e-9);
  EXPECT_NEAR(vortices->conserved()[0].value, start[0].value, 1e-14);
}

/// Exchange is antisymmetric to the last bit; the operator of the scenario is not, in disorder.
TEST(Vortex, KeepsCirculationByExchangeAndNotByAnOperator) {
  const auto drift = [](Diffusion diffusion) {
    const auto vortices = make_vortices(disordered(diffusion, 0.01));
    const auto start = vortices->conserved();
    take_steps(*vortices, 10, 0.02);
    return std::abs(vortices->conserved()[0].value - start[0].value) / start[0].scale;
  };
  EXPECT_LT(drift(Diffusion::particle_strength_exchange), 1e-14);
  EXPECT_GT(drift(Diffusion::sph), 1e-10);
}

/// The second moment of a vorticity grows by 4 nu t: by exchange and by cores nearly exactly, by an
/// operator with its error on blobs that are a third of the vortex apart.
TEST(Vortex, SpreadsAtFourTimesTheViscosity) {
  const double nu = 0.02, time = 0.1;
  const std::pair<Diffusion, double> tolerances[] = {{Diffusion::sph, 1e-2},
                                                     {Diffusion::particle_strength_exchange, 1e-3},
                                                     {Diffusion::core_spreading, 1e-10}};
  for (const auto& [diffusion, tolerance] : tolerances) {
    VortexCase flow = blobs_of(
        [](const Place& p) {
          return std::exp(-18 * (std::pow(p[0] - 1, 2) + std::pow(p[1] - 1, 2)));
        },
        0.06);
    flow.plan.jitter = 0;
    flow.options.diffusion = diffusion;
    flow.options.kinematic_viscosity = nu;
    flow.options.remesh_every = 5;
    const auto vortices = make_vortices(flow);
    const double before = told(*vortices, "second_moment");
    take_steps(*vortices, 10, time / 10);
    const double growth = told(*vortices, "second_moment") - before;
    EXPECT_NEAR(growth / (4 * nu * time), 1, tolerance) << static_cast<int>(diffusion);
  }
}

/// Grown cores are put on the lattice as circulation, and begin again at their size.
TEST(Vortex, ExchangesGrownCoresForCirculation) {
  VortexCase flow = disordered(Diffusion::core_spreading, 0.1);
  flow.options.remesh_every = 1;
  flow.options.remeshing = Remeshing::gauss;
  const auto vortices = make_vortices(flow);
  const double size = vortices->cloud().values("core_size")[0];
  const double before = told(*vortices, "second_moment");
  take_steps(*vortices, 10, 0.01);
  EXPECT_NEAR(told(*vortices, "second_moment") - before, 4 * 0.1 * 0.1, 1e-10);
  EXPECT_LT(vortices->cloud().values("core_size")[0], std::sqrt(size * size + 2 * 0.1 * 0.1));
}

TEST(Vortex, WalksAtRandomAsFarAsFrictionSpreads) {
  VortexCase flow = blobs_of([](const Place&) { return 1e-6; }, 0.02);
  flow.options.diffusion = Diffusion::random_walk;
  flow.options.kinematic_viscosity = 0.05;
  const auto vortices = make_vortices(flow);
  const double before = told(*vortices, "second_moment");
  take_steps(*vortices, 4, 0.5);
  const auto count = static_cast<double>(vortices->cloud().count());
  EXPECT_NEAR((told(*vortices, "second_moment") - before) / (4 * 0.05 * 2), 1,
              5 / std::sqrt(count));
  flow.options.seed = 1;
  const auto others = make_vortices(flow);
  take_steps(*others, 4, 0.5);
  EXPECT_NE(told(*others, "second_moment"), told(*vortices, "second_moment"));
}

TEST(Vortex, GoesWithTheFreeStream) {
  VortexCase flow = disordered();
  flow.options.free_stream = {"1/4", "1/4"};
  const auto vortices = make_vortices(flow);
  const double before = told(*vortices, "impulse_x"), circulation = vortices->conserved()[0].value;
  take_steps(*vortices, 10, 0.1);
  EXPECT_NEAR(told(*vortices, "impulse_x") - before, 0.25 * circulation, 1e-12);
}

/// Runge-Kutta's order, by the places after some time.
TEST(Vortex, IsOfTheOrderOfItsIntegrator) {
  const auto places = [](int steps) {
    const auto vortices = make_vortices(disordered());
    take_steps(*vortices, steps, 2.0 / steps);
    return std::vector<double>(vortices->cloud().position().begin(),
                               vortices->cloud().position().end());
  };
  const auto coarse = places(8), middle = places(16), fine = places(64);
  double first = 0, second = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    first = std::max(first, std::abs(coarse[k] - fine[k]));
    second = std::max(second, std::abs(middle[k] - fine[k]));
  }
  EXPECT_NEAR(std::log2(first / second), 4, 0.4);
}

TEST(Vortex, GoesOnFromASnapshotWithOtherVortices) {
  VortexCase flow = disordered(Diffusion::particle_strength_exchange, 0.01);
  flow.options.remesh_every = 3;
  const auto whole = make_vortices(flow), second = make_vortices(flow);
  take_steps(*whole, 4, 0.05);
  whole->complete_snapshot();
  const Cloud snapshot = whole->cloud();
  second->restore(snapshot);
  second->update_dependent_fields();
  take_steps(*whole, 4, 0.05, 0.2);
  take_steps(*second, 4, 0.05, 0.2);
  for (const char* field : {"position", "circulation", "velocity"}) {
    const auto a = whole->cloud().values(field), b = second->cloud().values(field);
    EXPECT_TRUE(std::ranges::equal(a, b)) << field;
  }
}

}  // namespace
}  // namespace mote::test
