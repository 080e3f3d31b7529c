#include "mote/walls/wall_diffusion.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "mote/walls/wall_remeshing.hpp"
#include "walls/exact_flows.hpp"

namespace mote::test {
namespace {

constexpr double viscosity = 0.01;
using Release = WallDiffusion::Release;

/// Moments of the distance n from one side of a large turned square, in a smooth window of the
/// length along the side whose integral is 1.
struct Layer {
  double circulation = 0, first = 0, second = 0;
};

/// Beside a square; a sheet of strength 1 sits on one of its sides, turned against the lattice.
struct PlaneWall {
  explicit PlaneWall(double spacing)
      : bodies(std::vector{Outline{square(2, std::polar(1.0, 0.3))}}, 0.08),
        lattice(bodies, spacing),
        diffusion(lattice, viscosity),
        circulation(bodies.panels().size()),
        vorticity(remeshed({}, lattice)) {
    side.normal = std::polar(1.0, 0.3);
    for (std::size_t k = 0; k < circulation.size(); ++k)
      if (std::abs(bodies.panels()[k].normal() - side.normal) < 0.1)
        circulation[k] = bodies.panels()[k].length();
  }

  Layer layer() const {
    Layer result;
    const LatticeParticles particles = particles_of(vorticity, lattice);
    for (std::size_t k = 0; k < particles.place.size(); ++k) {
      const Complex turned = particles.place[k] / side.normal;  // x away from the wall, y along it
      if (std::abs(turned.imag()) > 1 || turned.real() < 2) continue;
      const double part = particles.circulation[k] * (1 + std::cos(pi * turned.imag())) / 2;
      const double n = turned.real() - 2;
      result.circulation += part;
      result.first += part * n;
      result.second += part * n * n;
    }
    return result;
  }

  double total() const {
    return std::accumulate(vorticity.circulation.begin(), vorticity.circulation.end(), 0.0);
  }

  PanelBodies bodies;
  CutLattice lattice;
  WallDiffusion diffusion;
  std::vector<double> circulation;
  LatticeVorticity vorticity;
  struct {
    Complex normal;
  } side;
};

/// omega = exp(-n^2/(4 nu t))/sqrt(pi nu t): Rayleigh's layer (Stokes' first problem).
TEST(WallDiffusion, ASheetSpreadsAsInRayleighsProblem) {
  const auto error_of = [](double spacing) {
    constexpr double time = 0.3;
    PlaneWall wall(spacing);
    wall.diffusion.add_sheet(wall.circulation, time, Release::at_start, wall.vorticity);
    EXPECT_NEAR(wall.total(), 4, 1e-12);
    const Layer layer = wall.layer();
    EXPECT_NEAR(layer.circulation, 1, 2e-3);
    return std::max(std::abs(layer.first / std::sqrt(4 * viscosity * time / pi) - 1),
                    std::abs(layer.second / (2 * viscosity * time) - 1));
  };
  EXPECT_LT(error_of(0.04), 0.03);
  EXPECT_LT(error_of(0.02), 0.01);
}

/// Given off evenly it is younger: the mean of 2 nu t over the time, which also shows that the test
/// above is able to fail.
TEST(WallDiffusion, ASheetThatIsGivenOffEvenlyIsHalfAsOld) {
  constexpr double time = 0.3;
  PlaneWall wall(0.02);
  wall.diffusion.add_sheet(wall.circulation, time, Release::evenly, wall.vorticity);
  EXPECT_NEAR(wall.total(), 4, 1e-12);
  const double ratio = wall.layer().second / (2 * viscosity * time);
  EXPECT_NEAR(ratio, 0.5, 0.04);
}

/// Without sources the second moment of a layer at a wall goes on growing by 2 nu.
TEST(WallDiffusion, NothingPassesAWall) {
  PlaneWall wall(0.02);
  wall.diffusion.add_sheet(wall.circulation, 0.3, Release::at_start, wall.vorticity);
  const Layer before = wall.layer();
  wall.diffusion.diffuse(0.3, wall.vorticity);
  const Layer after = wall.layer();
  EXPECT_NEAR(wall.total(), 4, 1e-12);
  EXPECT_NEAR((after.second - before.second) / (2 * viscosity * 0.3), 1, 0.02);
}

/// d/dt of the impulse along the wall is nu omega at the wall; both as in Rayleigh's problem.
TEST(WallDiffusion, VorticityAtTheWallIsThatOfRayleighsProblem) {
  constexpr double time = 0.3;
  PlaneWall wall(0.02);
  wall.diffusion.add_sheet(wall.circulation, time, Release::at_start, wall.vorticity);
  const std::vector<double> nothing(wall.circulation.size());
  const std::vector<double> at_wall = wall.diffusion.wall_vorticity(nothing, 1, wall.vorticity);
  for (std::size_t k = 0; k < at_wall.size(); ++k)
    if (wall.circulation[k] > 0 &&
        std::abs((wall.bodies.panels()[k].middle() / wall.side.normal).imag()) < 1) {
      EXPECT_NEAR(at_wall[k] * std::sqrt(pi * viscosity * time), 1, 0.08);
    }
}

TEST(WallDiffusion, UniformVorticityStays) {
  PlaneWall wall(0.04);
  const NodeBox& box = wall.lattice.box();
  for (std::size_t cell = 0; cell < box.count(); ++cell)
    wall.vorticity.circulation[wall.vorticity.box.place(box.i(cell), box.j(cell))] =
        3 * wall.lattice.area(cell);
  const std::vector<double> before = wall.vorticity.circulation;
  wall.diffusion.diffuse(0.3, wall.vorticity);
  EXPECT_LT(error(before, wall.vorticity.circulation), 1e-15);
}

}  // namespace
}  // namespace mote::test
