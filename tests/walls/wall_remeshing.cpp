#include "mote/walls/wall_remeshing.hpp"

#include <gtest/gtest.h>

#include "mote/particles/failure.hpp"
#include "support/random.hpp"
#include "walls/exact_flows.hpp"

namespace mote::test {
namespace {

struct Moments {
  double circulation = 0;
  Complex first{}, second{};  ///< of z and z^2
  double square = 0;          ///< of |z|^2

  explicit Moments(const Vortices& vortices) {
    for (std::size_t k = 0; k < vortices.place.size(); ++k) {
      const Complex z = vortices.place[k];
      circulation += vortices.circulation[k];
      first += vortices.circulation[k] * z;
      second += vortices.circulation[k] * z * z;
      square += vortices.circulation[k] * std::norm(z);
    }
  }
  double difference_of_first(const Moments& other) const {
    return std::max(std::abs(circulation - other.circulation), std::abs(first - other.first));
  }
  double difference_of_second(const Moments& other) const {
    return std::max(std::abs(second - other.second), std::abs(square - other.square));
  }
};

struct RemeshingBesideWalls : testing::Test {
  double spacing = 0.05;
  PanelBodies bodies{std::vector{Outline{square(0.7, std::polar(1.0, 0.3))}}, 0.07};
  CutLattice lattice{bodies, spacing, {0.013, -0.007}};
  Draws draws{8};

  /// Beside all sides and corners, from so many spacings away on; negative is inside.
  std::vector<Complex> places_beside(double nearest) {
    std::vector<Complex> places;
    for (const Panel& panel : bodies.panels())
      for (int n = 0; n < 8; ++n)
        places.push_back(panel.middle() + draws.uniform(nearest, 4) * spacing * panel.normal() +
                         draws.uniform(-0.5, 0.5) * spacing * panel.tangent());
    return places;
  }
};

TEST_F(RemeshingBesideWalls, ConservesCirculationAndImpulse) {
  const std::vector<Complex> places = places_beside(-0.3);
  const std::vector<double> strength = draws.uniform(places.size(), -1, 1);
  const LatticeParticles after = particles_of(remeshed({places, strength}, lattice), lattice);
  EXPECT_LT(Moments({places, strength}).difference_of_first(Moments(after.vortices())), 1e-8);
}

TEST_F(RemeshingBesideWalls, ConservesSecondMomentsWhereItNeedNotReachFar) {
  const std::vector<Complex> places = places_beside(0.5);
  const std::vector<double> strength = draws.uniform(places.size(), -1, 1);
  const LatticeParticles after = particles_of(remeshed({places, strength}, lattice), lattice);
  EXPECT_LT(Moments({places, strength}).difference_of_second(Moments(after.vortices())), 1e-8);
}

/// Negative control: M4' alone, with the weights of the nodes in the wall left out.
TEST_F(RemeshingBesideWalls, LeavingOutNodesInAWallConservesNothing) {
  const std::vector<Complex> places = places_beside(0);
  const std::vector<double> strength(places.size(), 1);
  const PanelBodies far_away(std::vector{circle_outline({50, 0}, 1, 8)}, 1);
  const CutLattice open(far_away, spacing, {0.013, -0.007});
  LatticeVorticity all = remeshed({places, strength}, open);
  for (std::size_t k = 0; k < all.circulation.size(); ++k)
    if (!lattice.carries(all.box.i(k), all.box.j(k))) all.circulation[k] = 0;
  const LatticeParticles after = particles_of(all, open);
  EXPECT_GT(Moments({places, strength}).difference_of_first(Moments(after.vortices())), 1);
}

TEST_F(RemeshingBesideWalls, RefusesVorticesDeepInABody) {
  const std::vector<Complex> places{{0.1, 0.1}};
  const std::vector<double> strength{1};
  EXPECT_THROW(remeshed({places, strength}, lattice), NumericalFailure);
}

TEST_F(RemeshingBesideWalls, ParticlesInTheirPlacesStay) {
  std::vector<Complex> places;
  for (std::size_t cell = 0; cell < lattice.box().count(); ++cell)
    if (lattice.owner(cell) == cell)
      places.push_back(lattice.place(lattice.box().i(cell), lattice.box().j(cell)));
  const std::vector<double> strength = draws.uniform(places.size(), -1, 1);
  const LatticeParticles after = particles_of(remeshed({places, strength}, lattice), lattice);
  double worst = 0;
  std::size_t n = 0;
  for (std::size_t k = 0; k < after.place.size() && n < places.size(); ++k)
    if (after.place[k] == places[n])
      worst = std::max(worst, std::abs(after.circulation[k] - strength[n++]));
  EXPECT_EQ(n, places.size());
  EXPECT_LT(worst, 1e-4);
}

TEST_F(RemeshingBesideWalls, WeakOnesAreDroppedAndAccountedFor) {
  const std::vector<Complex> places{{2, 1}, {2.1, -0.7}};
  const std::vector<double> strength{1, -0.4};
  LatticeVorticity vorticity = remeshed({places, strength}, lattice);
  const auto count = particles_of(vorticity, lattice).place.size();
  const LostVorticity lost = drop_weak(lattice, 0.05, vorticity);
  const LatticeParticles after = particles_of(vorticity, lattice);
  EXPECT_LT(after.place.size(), count);
  const Moments moments(after.vortices());
  EXPECT_NEAR(moments.circulation + lost.circulation, 0.6, 1e-14);
  const Complex impulse = impulse_of(1, moments.first) + lost.impulse;
  EXPECT_LT(std::abs(impulse - impulse_of(1, places[0]) + impulse_of(0.4, places[1])), 1e-13);
}

}  // namespace
}  // namespace mote::test
