#include "mote/walls/panel_bodies.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "walls/exact_flows.hpp"

namespace mote::test {
namespace {

struct Cylinder {
  explicit Cylinder(Index panels) : bodies(std::vector{circle_outline(0, 1, panels)}, 10) {}

  /// Of the surface speed in a stream, -2 sin theta + Gamma/(2 pi).
  double error(double circulation, double given) const {
    std::vector<double> exact;
    for (const Panel& panel : bodies.panels())
      exact.push_back(-2 * std::sin(std::arg(panel.middle())) + circulation / (2 * pi));
    return test::error(sheet_in_stream(bodies, given), exact);
  }

  PanelBodies bodies;
};

TEST(PanelBodies, SurfaceSpeedOfACylinderIsOfSecondOrder) {
  for (const double circulation : {0.0, 1.3}) {
    const double coarse = Cylinder(64).error(circulation, circulation);
    const double fine = Cylinder(128).error(circulation, circulation);
    const double finest = Cylinder(256).error(circulation, circulation);
    EXPECT_NEAR(order(coarse, fine), 2, 0.1);
    EXPECT_NEAR(order(fine, finest), 2, 0.1);
    EXPECT_LT(finest, 2e-4);
  }
}

/// Negative control: with another circulation the error stalls.
TEST(PanelBodies, SurfaceSpeedNeedsItsCirculation) {
  EXPECT_LT(order(Cylinder(64).error(1.3, 1.2), Cylinder(128).error(1.3, 1.2)), 0.2);
}

/// Milne-Thomson's circle theorem: the images of a vortex at z0 are one of opposite circulation at
/// 1/conj(z0) and, here, none in the middle. u - iv on the circle.
TEST(PanelBodies, AVortexBesideACylinderHasItsImages) {
  const std::vector<Complex> place{{1.2, 0.5}};
  const std::vector<double> strength{2};
  const auto error_of = [&](Index panels) {
    const Cylinder cylinder(panels);
    const std::vector<double> sheet = sheet_in_stream(cylinder.bodies, 0, {place, strength});
    std::vector<double> exact;
    for (const Panel& panel : cylinder.bodies.panels()) {
      const Complex z = panel.middle() / std::abs(panel.middle());
      const Complex image = 1.0 / std::conj(place[0]);
      const Complex conjugate = 1.0 - 1.0 / (z * z) +
                                strength[0] / (2 * pi * Complex(0, 1)) *
                                    (1.0 / (z - place[0]) - 1.0 / (z - image) + 1.0 / z);
      exact.push_back((conjugate * panel.tangent()).real());
    }
    return error(sheet, exact);
  };
  EXPECT_NEAR(order(error_of(128), error_of(256)), 2, 0.15);
  EXPECT_LT(error_of(256), 1e-2);
}

/// z = w + c^2/w maps a circle of radius 1 to an ellipse.
TEST(PanelBodies, SurfaceSpeedOfAnEllipseIsOfSecondOrder) {
  const auto error_of = [](Index panels) {
    constexpr double c2 = 0.5;
    Outline ellipse;
    for (Index k = 0; k < panels; ++k) {
      const Complex w = std::polar(1.0, 2 * pi * k / panels);
      ellipse.corners.push_back(w + c2 / w);
    }
    const PanelBodies bodies(std::vector{ellipse}, 10);
    std::vector<double> exact;
    for (Index k = 0; k < panels; ++k) {
      const double theta = 2 * pi * (k + 0.5) / panels;
      const Complex w = std::polar(1.0, theta);
      exact.push_back(-2 * std::sin(theta) / std::abs(1.0 - c2 / (w * w)));
    }
    return error(sheet_in_stream(bodies, 0), exact);
  };
  EXPECT_NEAR(order(error_of(64), error_of(128)), 2, 0.15);
  EXPECT_NEAR(order(error_of(128), error_of(256)), 2, 0.15);
}

/// The fluid in a square is at rest. Far away it is seen as a cylinder of radius
/// c = Gamma(1/4)^2/(4 pi^(3/2)) times its side, the transfinite diameter: u = 1 + c^2/y^2 on the
/// y-axis, as the square's fourfold symmetry leaves out the next term.
TEST(PanelBodies, ASquareIsAtRestInsideAndADipoleFarAway) {
  const PanelBodies bodies(std::vector{Outline{square(0.5)}}, 0.01);
  const std::vector<double> sheet = sheet_in_stream(bodies, 0);
  const std::vector<Complex> places{{0, 0}, {0.3, -0.2}, {0, 30}};
  std::vector<Complex> velocity(places.size(), 1);
  bodies.add_velocity(sheet, places, velocity);
  EXPECT_LT(std::abs(velocity[0]), 1e-3);
  EXPECT_LT(std::abs(velocity[1]), 1e-3);
  const double c = std::pow(std::tgamma(0.25), 2) / (4 * std::pow(pi, 1.5));
  EXPECT_NEAR((velocity[2].real() - 1) * 30 * 30, c * c, 2e-3 * c * c);
}

TEST(PanelBodies, EveryBodyHasItsCirculation) {
  const PanelBodies bodies(
      std::vector{circle_outline(0, 1, 60), circle_outline({2.5, 0.4}, 0.8, 50)}, 10);
  const std::vector<double> required{0.7, -0.3};
  const std::vector<double> sheet = bodies.sheet(bodies.circulation_along_panels(1, {}), required);
  EXPECT_NEAR(bodies.circulation(sheet, 0), 0.7, 1e-13);
  EXPECT_NEAR(bodies.circulation(sheet, 1), -0.3, 1e-13);
  std::vector<Complex> velocity(2, 1);
  bodies.add_velocity(sheet, std::vector<Complex>{{0.2, 0.1}, {2.4, 0.3}}, velocity);
  EXPECT_LT(std::abs(velocity[0]), 2e-3);
  EXPECT_LT(std::abs(velocity[1]), 2e-3);
}

/// Sums eight at a time against one by one, near and far.
TEST(PanelBodies, SumsAreThoseOfSinglePanels) {
  const PanelBodies bodies(std::vector{circle_outline(0, 1, 40)}, 10);
  Draws draws(3);
  std::vector<Complex> places;
  for (int n = 0; n < 37; ++n)
    places.push_back(std::polar(draws.uniform(1.01, 9), draws.uniform(0, 6)));
  const std::vector<double> strength = draws.uniform(37, -1, 1), sheet = draws.uniform(40, -1, 1);
  std::vector<Complex> velocity(places.size());
  bodies.add_velocity(sheet, places, velocity);
  const std::vector<double> along = bodies.circulation_along_panels(0, {places, strength});
  for (std::size_t n = 0; n < places.size(); ++n) {
    Complex sum{};
    for (std::size_t k = 0; k < sheet.size(); ++k)
      sum += sheet[k] * velocity_of_sheet(bodies.panels()[k], places[n]);
    EXPECT_LT(std::abs(velocity[n] - sum), 1e-10);
  }
  for (std::size_t k = 0; k < sheet.size(); ++k) {
    double sum = 0;
    for (std::size_t n = 0; n < places.size(); ++n)
      sum += strength[n] * circulation_of_vortex(bodies.panels()[k], places[n]);
    EXPECT_NEAR(along[k], sum, 1e-11);
  }
}

}  // namespace
}  // namespace mote::test
