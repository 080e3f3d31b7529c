#include "mote/walls/cut_lattice.hpp"

#include <gtest/gtest.h>

#include "mote/walls/clipping.hpp"
#include "walls/exact_flows.hpp"

namespace mote::test {
namespace {

/// A turned square and a circle beside it, on a lattice with its nodes anywhere.
struct CutLattices : testing::Test {
  double spacing = 0.05;
  Outline circle = circle_outline({1.9, 0.2}, 0.6, 60);
  Outline turned{square(0.7, std::polar(1.0, 0.3))};
  PanelBodies bodies{std::vector{turned, circle}, 0.07};
  CutLattice lattice{bodies, spacing, {0.013, -0.007}};

  bool carries(std::size_t cell) const { return lattice.owner(cell) == cell; }
  Complex place(std::size_t cell) const {
    return lattice.place(lattice.box().i(cell), lattice.box().j(cell));
  }
  double distance_outside(Complex place) const {
    double winding = 0, nearest = 1e9;
    for (const Panel& panel : bodies.panels()) {
      winding += circulation_of_vortex(panel, place);
      nearest = std::min(nearest, std::abs(place - panel.middle()) - panel.length() / 2);
    }
    return winding > 0.5 ? -1 : nearest;
  }
};

TEST_F(CutLattices, AreasSumToThatOfTheFluid) {
  double sum = 0;
  for (std::size_t cell = 0; cell < lattice.box().count(); ++cell) sum += lattice.area(cell);
  const double box = static_cast<double>(lattice.box().count()) * spacing * spacing;
  EXPECT_NEAR(sum, box - area_of(turned) - area_of(circle), 1e-12);
}

TEST_F(CutLattices, ParticlesStandAtTheCentroidOfTheFluid) {
  Complex sum{};
  for (std::size_t cell = 0; cell < lattice.box().count(); ++cell)
    sum += lattice.area(cell) * place(cell);
  const NodeBox& box = lattice.box();
  const Complex middle = lattice.node(box.first_i, box.first_j) +
                         0.5 * spacing * Complex(box.columns - 1, box.rows - 1);
  const double area = static_cast<double>(box.count()) * spacing * spacing;
  const Complex exact = area * middle - area_of(circle) * Complex(1.9, 0.2);
  EXPECT_LT(std::abs(sum - exact), 1e-4);
}

TEST_F(CutLattices, ParticlesStandOutsideInCellsThatAreNotSmall) {
  for (std::size_t cell = 0; cell < lattice.box().count(); ++cell) {
    EXPECT_EQ(carries(cell), lattice.area(cell) > 0);
    if (!carries(cell)) continue;
    EXPECT_GE(lattice.area(cell), 0.49 * spacing * spacing);
    EXPECT_GT(distance_outside(place(cell)), -0.5) << place(cell);
  }
}

TEST_F(CutLattices, EveryPanelGivesAllOfItselfToCellsThatCarry) {
  std::vector<double> sum(bodies.panels().size());
  for (const PanelShare& share : lattice.shares()) {
    EXPECT_TRUE(carries(share.cell));
    EXPECT_LT(share.distance, 1.6 * spacing);
    sum[share.panel] += share.fraction;
  }
  for (const double part : sum) EXPECT_NEAR(part, 1, 1e-12);
}

TEST(Clipping, CoversOfACornerInACell) {
  const std::vector<Panel> panels = panels_of({square(1)}, 0.3);
  const Cover corner = cover_of(panels, {1.1, 0.9}, 0.5);  // x from 0.85, y from 0.65 to 1.15
  EXPECT_NEAR(corner.area, 0.15 * 0.35, 1e-14);
  EXPECT_NEAR(corner.right, 0, 1e-14);
  EXPECT_NEAR(corner.above, 0, 1e-14);
  const Cover side = cover_of(panels, {0.1, 1.1}, 0.5);
  EXPECT_NEAR(side.area, 0.5 * 0.15, 1e-14);
  EXPECT_NEAR(side.right, 0.15, 1e-14);
  EXPECT_NEAR(side.above, 0, 1e-14);
  EXPECT_NEAR(std::abs(side.moment - side.area * Complex(0, -0.175)), 0, 1e-14);
  EXPECT_NEAR(cover_of(panels, 0, 0.5).above, 0.5, 1e-14);
  EXPECT_NEAR(cover_of(panels, {3, 0}, 0.5).area, 0, 1e-14);
}

TEST(Clipping, PiecesOfAPanel) {
  const Panel panel{{-1, 0}, {3, 0}};
  EXPECT_NEAR(piece_inside(panel, 0, 1).from, 0.125, 1e-14);
  EXPECT_NEAR(piece_inside(panel, 0, 1).to, 0.375, 1e-14);
  EXPECT_GE(piece_inside(panel, {0, 2}, 1).from, piece_inside(panel, {0, 2}, 1).to);
}

}  // namespace
}  // namespace mote::test
