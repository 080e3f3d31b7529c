// Vortices in space: velocity, stretching and what they keep.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "support/space_vortex_case.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;

Vec<3> at(std::span<const double> values, Index i) {
  return Vec<3>::Map(values.data() + std::ptrdiff_t{i} * 3);
}

/// Two blobs side by side, of different directions.
SpaceVortexCase pair_of_blobs(std::optional<Stretching> form) {
  auto flow = fluid_in_a_box<SpaceVortexCase>(3, 1, {2, 1, 1});
  flow.options.core_size = 0.8;
  flow.options.stretching = form;
  flow.vorticity = [](const Place& p) {
    return p[0] < 1 ? Triple{0.3, -1, 0.5} : Triple{0.7, 0.2, -0.4};
  };
  return in_disorder(flow, 0.3);
}

/// The velocity that a blob of this size induces, written down a second time.
Vec<3> velocity_by(const Vec<3>& alpha, const Vec<3>& r, double size) {
  const double rho = r.norm() / size;
  const double q =
      std::erf(rho / std::sqrt(2)) - std::sqrt(2 / pi) * rho * std::exp(-rho * rho / 2);
  return q / (4 * pi * std::pow(r.norm(), 3)) * alpha.cross(r);
}

struct PairOfBlobs : testing::TestWithParam<Stretching> {};

/// Of both vortices, against differences of the other one's velocity.
TEST_P(PairOfBlobs, MovesAndStretchesAsTheVelocitySays) {
  const auto vortices = make_vortices(pair_of_blobs(GetParam()));
  const Cloud& cloud = vortices->cloud();
  ASSERT_EQ(cloud.count(), 2);
  vortices->update_drift_rates(0);
  vortices->update_kick_rates(0);
  constexpr double size = 0.8, step = 1e-5;
  for (const Index i : {0, 1}) {
    const Vec<3> alpha = at(cloud.values("circulation"), i);
    const Vec<3> other = at(cloud.values("circulation"), 1 - i);
    const Vec<3> apart = at(cloud.position(), i) - at(cloud.position(), 1 - i);
    EXPECT_LT((at(cloud.values("velocity"), i) - velocity_by(other, apart, size)).norm(), 1e-14);
    Mat<3> slope;
    for (int b = 0; b < 3; ++b)
      slope.col(b) = (velocity_by(other, apart + step * Vec<3>::Unit(b), size) -
                      velocity_by(other, apart - step * Vec<3>::Unit(b), size)) /
                     (2 * step);
    const Vec<3> transposed = slope.transpose() * alpha, classical = slope * alpha;
    const bool is_transposed = GetParam() == Stretching::transposed;
    const Vec<3> rate = at(vortices->kicked()[0].rate, i);
    EXPECT_LT((rate - (is_transposed ? transposed : classical)).norm(), 1e-9 * alpha.norm());
    EXPECT_GT((rate - (is_transposed ? classical : transposed)).norm(), 1e-3 * rate.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, PairOfBlobs,
                         testing::Values(Stretching::transposed, Stretching::classical));

double circulation_drift(std::optional<Stretching> form) {
  SpaceVortexCase flow = tangle();
  flow.options.stretching = form;
  const auto vortices = make_vortices(flow);
  auto start = vortices->conserved();
  take_steps(*vortices, 10, 0.05);
  start.resize(3);
  return largest_drift(start, vortices->conserved());
}

/// Pair by pair what two vortices give each other cancels in the transposed form, which is the
/// default; in the classical one it does not.
TEST(VortexInSpace, KeepsCirculationToRoundingInTheTransposedForm) {
  EXPECT_LT(circulation_drift({}), 1e-14);
  EXPECT_LT(circulation_drift(Stretching::transposed), 1e-14);
  EXPECT_GT(circulation_drift(Stretching::classical), 1e-6);
}

/// Exchange is antisymmetric too.
TEST(VortexInSpace, KeepsCirculationByExchange) {
  SpaceVortexCase flow = tangle();
  flow.options.kinematic_viscosity = 0.01;
  flow.options.diffusion = Diffusion::particle_strength_exchange;
  const auto vortices = make_vortices(flow);
  auto start = vortices->conserved();
  const double before = told(*vortices, "magnitude");
  take_steps(*vortices, 5, 0.05);
  start.resize(3);
  EXPECT_LT(largest_drift(start, vortices->conserved()), 1e-14);
  EXPECT_LT(told(*vortices, "magnitude"), before);
}

/// d/dt of the sum of x alpha by exchange alone is nothing, and of x^2 alpha 2 D nu alpha: so the
/// rates are those of nu lap in space.
TEST(VortexInSpace, SpreadsAtSixTimesTheViscosity) {
  const double nu = 0.02;
  auto flow = fluid_in_a_box<SpaceVortexCase>(3, 0.125, {2, 2, 2});
  flow.options.kinematic_viscosity = nu;
  for (const Diffusion diffusion : {Diffusion::particle_strength_exchange, Diffusion::sph}) {
    flow.options.diffusion = diffusion;
    flow.vorticity = [](const Place& p) {
      const double x = p[0] - 1, y = p[1] - 1, z = p[2] - 1;
      return Triple{0, 0, 1e-9 * std::exp(-20 * (x * x + y * y + z * z))};
    };
    const auto vortices = make_vortices(flow);
    vortices->update_kick_rates(0);
    double squares = 0, circulation = 0;
    for (Index i = 0; i < vortices->cloud().count(); ++i) {
      const Vec<3> x = at(vortices->cloud().position(), i) - Vec<3>::Ones();
      squares += x.squaredNorm() * at(vortices->kicked()[0].rate, i)[2];
      circulation += at(vortices->cloud().values("circulation"), i)[2];
    }
    EXPECT_NEAR(squares / (6 * nu * circulation), 1, 0.02) << static_cast<int>(diffusion);
  }
}

TEST(VortexInSpace, GoesWithTheFreeStreamAndIsNotStretchedByAUniformOne) {
  SpaceVortexCase flow = one_ring();
  const auto still = make_vortices(flow);
  flow.options.free_stream = {"1/4", "1/4", "1/4"};
  const auto carried = make_vortices(flow);
  take_steps(*still, 2, 0.05);
  take_steps(*carried, 2, 0.05);
  EXPECT_NEAR(told(*carried, "centre_z") - told(*still, "centre_z"), 0.25 * 0.1, 1e-9);
  EXPECT_NEAR(told(*carried, "magnitude"), told(*still, "magnitude"), 1e-7);
}

TEST(VortexRings, HaveTheCirculationAndTheMomentsThatTheyAreGiven) {
  const double core = 0.25;
  const auto vortices = make_vortices(one_ring(0.1, core));
  EXPECT_NEAR(told(*vortices, "magnitude"), 2 * pi, 1e-12);
  EXPECT_NEAR(told(*vortices, "circulation_z"), 0, 1e-14);
  // impulse: Gamma pi times the mean of rho^2 over the core
  const double blobs = std::pow(1.5 * 0.1, 2);
  const double particles = 0.5 * core * core - blobs;
  EXPECT_NEAR(told(*vortices, "impulse_z"), pi * (1 + particles), 1e-10);
  EXPECT_NEAR(told(*vortices, "centre_z"), 0, 1e-14);
}

TEST(VortexRings, MayLieInAnyPlane) {
  const auto upright = make_vortices(one_ring(0.15, 0.35));
  const auto oblique = make_vortices(one_ring(0.15, 0.35, {2, -1, 2}));
  const Vec<3> normal = Vec<3>(2, -1, 2) / 3;
  const double impulse = told(*upright, "impulse_z");
  take_steps(*upright, 3, 0.1);
  take_steps(*oblique, 3, 0.1);
  for (int d = 0; d < 3; ++d) {
    const std::string axis = axis_names[d];
    EXPECT_NEAR(told(*oblique, "impulse_" + axis), impulse * normal[d], 1e-5);
    EXPECT_NEAR(told(*oblique, "centre_" + axis), told(*upright, "centre_z") * normal[d], 1e-6);
  }
  EXPECT_GT(told(*upright, "centre_z"), 0.05);
}

/// The impulse of a ring stays but for the divergence that its particles have, and so does the
/// Hamiltonian.
TEST(VortexRings, KeepTheirImpulse) {
  for (const Stretching form : {Stretching::transposed, Stretching::classical}) {
    SpaceVortexCase flow = one_ring(0.1, 0.25);
    flow.options.stretching = form;
    const auto vortices = make_vortices(flow);
    const auto start = vortices->conserved();
    const double energy = told(*vortices, "hamiltonian");
    take_steps(*vortices, 5, 0.1);
    EXPECT_LT(largest_drift(start, vortices->conserved()), 1e-4);
    EXPECT_NEAR(told(*vortices, "hamiltonian") / energy, 1, 1e-3);
  }
}

TEST(VortexRings, KeepCirculationAndImpulseOnALattice) {
  SpaceVortexCase flow = one_ring(0.15, 0.35);
  flow.options.remesh_every = 1;
  const auto vortices = make_vortices(flow);
  const auto start = vortices->conserved();
  const Index before = vortices->cloud().count();
  take_steps(*vortices, 1, 1e-9);
  EXPECT_NE(vortices->cloud().count(), before);
  auto end = vortices->conserved();
  end.resize(6);
  EXPECT_LT(largest_drift({start.begin(), start.begin() + 6}, end), 1e-9);
}

TEST(VortexRings, GoOnFromASnapshot) {
  const SpaceVortexCase flow = one_ring(0.15, 0.35);
  const auto whole = make_vortices(flow), second = make_vortices(flow);
  take_steps(*whole, 2, 0.05);
  whole->complete_snapshot();
  second->restore(whole->cloud());
  second->update_dependent_fields();
  take_steps(*whole, 2, 0.05, 0.1);
  take_steps(*second, 2, 0.05, 0.1);
  for (const char* field : {"position", "circulation", "velocity", "ring"})
    EXPECT_TRUE(std::ranges::equal(whole->cloud().values(field), second->cloud().values(field)))
        << field;
}

}  // namespace
}  // namespace mote::test
