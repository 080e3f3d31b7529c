#include "mote/walls/panel.hpp"

#include <gtest/gtest.h>

#include "mote/particles/failure.hpp"
#include "mote/walls/outline.hpp"
#include "support/quadrature.hpp"
#include "support/random.hpp"
#include "walls/exact_flows.hpp"

namespace mote::test {
namespace {

/// Velocity u + iv of a unit vortex, (-y, x)/(2 pi r^2).
Complex vortex(Complex offset) { return Complex(0, 1) * offset / (2 * pi * std::norm(offset)); }

Complex at(const Panel& panel, long double t) {
  return panel.from + static_cast<double>(t) * (panel.to - panel.from);
}

double along(const Panel& panel, Complex velocity) {
  return (std::conj(panel.tangent()) * velocity).real();
}

struct Panels : testing::Test {
  Draws draws{5};
  Panel panel{{0.2, -0.1}, {0.5, 0.3}};
  Complex random_place(double reach) {
    return panel.middle() + Complex(draws.uniform(-reach, reach), draws.uniform(-reach, reach));
  }
};

Complex velocity_by_quadrature(const Panel& panel, Complex place) {
  const auto part = [&](auto component) {
    return static_cast<double>(panel_integral(
        [&](long double t) { return component(vortex(place - at(panel, t))); }, 0, 1));
  };
  return panel.length() * Complex(part([](Complex v) { return v.real(); }),
                                  part([](Complex v) { return v.imag(); }));
}

bool cross(const Panel& a, const Panel& b) {
  const auto parts = [](const Panel& line, const Panel& ends) {
    return circulation_of_vortex(line, ends.from) * circulation_of_vortex(line, ends.to) < 0;
  };
  return parts(a, b) && parts(b, a);
}

TEST_F(Panels, VelocityIsTheIntegralOfVortices) {
  for (const double reach : {0.4, 2.0, 40.0})
    for (int n = 0; n < 40; ++n) {
      const Complex place = random_place(reach), exact = velocity_by_quadrature(panel, place);
      EXPECT_LT(std::abs(velocity_of_sheet(panel, place) - exact), 1e-8 * std::abs(exact)) << place;
    }
}

TEST_F(Panels, TangentialVelocityJumpsByTheStrength) {
  const Complex step = 1e-9 * panel.normal(), place = panel.from + 0.3 * (panel.to - panel.from);
  const Complex outside = velocity_of_sheet(panel, place + step);
  const Complex inside = velocity_of_sheet(panel, place - step);
  EXPECT_NEAR(along(panel, outside), 0.5, 1e-8);
  EXPECT_NEAR(along(panel, inside), -0.5, 1e-8);
  EXPECT_NEAR(std::abs(outside - inside), 1, 1e-7);
}

TEST_F(Panels, CirculationOfAVortexIsTheIntegralAlongThePanel) {
  for (const double reach : {0.4, 2.0, 40.0})
    for (int n = 0; n < 40; ++n) {
      const Complex place = random_place(reach);
      const double exact =
          panel.length() *
          static_cast<double>(panel_integral(
              [&](long double t) { return along(panel, vortex(at(panel, t) - place)); }, 0, 1));
      EXPECT_NEAR(circulation_of_vortex(panel, place), exact, 1e-8) << place;
    }
}

TEST_F(Panels, CirculationAroundAClosedOutlineIsThatOfTheVorticesInside) {
  double inside = 0, outside = 0;
  for (const Panel& side : panels_of({square(1)}, 0.13)) {
    inside += circulation_of_vortex(side, {0.3, -0.98});
    outside += circulation_of_vortex(side, {0.3, -1.02});
  }
  EXPECT_NEAR(inside, 1, 1e-14);
  EXPECT_NEAR(outside, 0, 1e-14);
}

TEST_F(Panels, CirculationOfASheetIsTheIntegralOfItsVelocity) {
  for (int n = 0; n < 200; ++n) {
    const Complex start = random_place(1.5);
    const Panel other{start, start + Complex(draws.uniform(-0.3, 0.3), draws.uniform(-0.3, 0.3))};
    const double exact =
        other.length() *
        static_cast<double>(panel_integral(
            [&](long double t) { return circulation_of_vortex(panel, at(other, t)); }, 0, 1));
    if (!cross(panel, other)) {
      EXPECT_NEAR(circulation_of_sheet(panel, other), exact, 1e-6);
    }
  }
}

/// Panels that share a corner, and all of a closed outline: a sheet beside it is seen as a whole.
TEST_F(Panels, CirculationsAroundAClosedOutlineSumToThatOfTheSheetsInside) {
  const std::vector<Panel> sides = panels_of({square(1, std::polar(1.0, 0.4))}, 0.3);
  for (const Panel& of : sides) {
    double sum = 0;
    for (const Panel& on : sides)
      if (on.from != of.from) sum += circulation_of_sheet(on, of);
    EXPECT_NEAR(sum, of.length() / 2, 1e-13);
  }
}

TEST(Outlines, KeepTheirCornersAndRunCounterClockwise) {
  std::vector<Complex> corners = square(1);
  std::ranges::reverse(corners);
  const std::vector<Panel> panels = panels_of({corners}, 0.3);
  EXPECT_EQ(panels.size(), 28u);
  Outline outline;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    outline.corners.push_back(panels[k].from);
    EXPECT_EQ(panels[k].to, panels[(k + 1) % panels.size()].from);
    EXPECT_LE(panels[k].length(), 0.3);
  }
  EXPECT_NEAR(area_of(outline), 4, 1e-13);
  for (const Complex corner : corners)
    EXPECT_EQ(std::ranges::count(outline.corners, corner), 1) << corner;
}

TEST(Outlines, ACircleHasItsArea) {
  EXPECT_NEAR(area_of(circle_outline({3, 1}, 0.5, 12)), pi / 4, 1e-14);
}

TEST(Outlines, RefuseWhatIsNoPolygon) {
  EXPECT_THROW(panels_of({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, 0.1), InputError);
  EXPECT_THROW(panels_of({{{0, 0}, {1, 1}}}, 0.1), InputError);
}

}  // namespace
}  // namespace mote::test
