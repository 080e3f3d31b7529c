#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mote/exact/kirchhoff_ellipse.hpp"
#include "mote/exact/lamb_oseen.hpp"
#include "mote/exact/vortex_pair.hpp"

namespace mote::test {
namespace {

using std::numbers::pi;
using Velocity = std::array<double, 2>;

constexpr double step = 1e-4;  // of central differences, whose errors are of the order step^2

Velocity velocity(const FlowSolution& flow, double x, double y, double t) {
  const double place[] = {x, y};
  const Table table = flow.at_places(place, 2, t);
  return {table[0].values[0], table[1].values[0]};
}

double divergence(const FlowSolution& flow, double x, double y, double t) {
  return (velocity(flow, x + step, y, t)[0] - velocity(flow, x - step, y, t)[0] +
          velocity(flow, x, y + step, t)[1] - velocity(flow, x, y - step, t)[1]) /
         (2 * step);
}

double curl(const FlowSolution& flow, double x, double y, double t) {
  return (velocity(flow, x + step, y, t)[1] - velocity(flow, x - step, y, t)[1] -
          velocity(flow, x, y + step, t)[0] + velocity(flow, x, y - step, t)[0]) /
         (2 * step);
}

double vorticity(const FlowSolution& flow, double x, double y, double t) {
  const double place[] = {x, y};
  return flow.at_places(place, 2, t).back().values[0];
}

constexpr GaussVortex spreading{3, {0.1, -0.2}, 0.5, 0.02};

/// d omega/dt - nu lap omega of a round vortex, which its own velocity does not carry anywhere.
double diffusion_residual(const LambOseen& flow, double x, double y, double viscosity) {
  constexpr double t = 1.5, wide = 1e-3;
  const auto omega = [&](double dx, double dy, double dt) {
    return vorticity(flow, x + dx, y + dy, t + dt);
  };
  const double laplacian = (omega(wide, 0, 0) + omega(-wide, 0, 0) + omega(0, wide, 0) +
                            omega(0, -wide, 0) - 4 * omega(0, 0, 0)) /
                           (wide * wide);
  const double rate = (omega(0, 0, wide) - omega(0, 0, -wide)) / (2 * wide);
  return std::abs(rate - viscosity * laplacian);
}

TEST(LambOseen, SolvesTheEquationOfVorticity) {
  const LambOseen flow(spreading);
  for (const double x : {0.1, 0.7, 2.0}) {
    EXPECT_NEAR(divergence(flow, x, 0.3, 1.5), 0, 1e-7);
    EXPECT_NEAR(curl(flow, x, 0.3, 1.5), vorticity(flow, x, 0.3, 1.5), 1e-7);
    EXPECT_LT(diffusion_residual(flow, x, 0.3, spreading.viscosity), 1e-6);
  }
}

TEST(LambOseen, CheckNoticesAnotherViscosity) {
  EXPECT_GT(diffusion_residual(LambOseen(spreading), 0.7, 0.3, 1.01 * spreading.viscosity), 1e-5);
}

TEST(LambOseen, IsFastestWhereTheTextbooksSay) {
  GaussVortex vortex{.circulation = 2, .variance = 1, .viscosity = 0.1};
  const LambOseen flow(vortex);
  const double length = std::sqrt(2 * flow.variance(3));  // sqrt(4 nu t) of a vortex born a point
  const double radius = 1.12091 * length;
  EXPECT_NEAR(velocity(flow, radius, 0, 3)[1], 0.63817 * 2 / (2 * pi * length), 1e-5);
  for (const double factor : {0.99, 1.01})
    EXPECT_LT(velocity(flow, factor * radius, 0, 3)[1], velocity(flow, radius, 0, 3)[1]);
}

constexpr VortexEllipse turning{1.7, 2, 1, {0.3, -0.1}, 0.4};

/// Velocity across the edge of the ellipse, at a place of it, less that of the edge, which turns.
double leak(const VortexEllipse& ellipse, double rate, double t) {
  const KirchhoffEllipse flow(ellipse);
  const double phase = 1.1, angle = ellipse.angle + flow.turning_rate() * t;
  const double a = ellipse.long_axis, b = ellipse.short_axis;
  const auto turned = [&](double x, double y) {
    return Velocity{std::cos(angle) * x - std::sin(angle) * y,
                    std::sin(angle) * x + std::cos(angle) * y};
  };
  const Velocity r = turned(a * std::cos(phase), b * std::sin(phase));
  const Velocity normal = turned(std::cos(phase) / a, std::sin(phase) / b);
  const Velocity u = velocity(flow, ellipse.centre[0] + r[0], ellipse.centre[1] + r[1], t);
  return (u[0] + rate * r[1]) * normal[0] + (u[1] - rate * r[0]) * normal[1];
}

TEST(KirchhoffEllipse, IsVorticityWithinAnEdgeThatTurnsWithTheFluid) {
  const KirchhoffEllipse flow(turning);
  EXPECT_NEAR(flow.turning_rate(), 2 * turning.vorticity / 9, 1e-15);
  for (const double t : {0.0, 2.0}) {
    EXPECT_NEAR(curl(flow, 0.4, 0.1, t), turning.vorticity, 1e-7);
    EXPECT_NEAR(leak(turning, flow.turning_rate(), t), 0, 1e-13);
    for (const double x : {-3.0, 2.9}) {
      EXPECT_NEAR(curl(flow, x, -0.5, t), 0, 1e-7);
      EXPECT_NEAR(divergence(flow, x, -0.5, t), 0, 1e-7);
    }
  }
  const double far = 1e4;
  EXPECT_NEAR(velocity(flow, far, 0, 0)[1] * 2 * pi * far / (turning.vorticity * pi * 2), 1, 1e-4);
}

TEST(KirchhoffEllipse, CheckNoticesAnotherRate) {
  EXPECT_GT(std::abs(leak(turning, 1.001 * KirchhoffEllipse(turning).turning_rate(), 2)), 1e-5);
}

TEST(KirchhoffEllipse, HasNoJumpAtItsEdge) {
  for (const double angle : {0.2, 1.5, 3.0, -2.0}) {
    const VortexEllipse level{1, 2, 1};
    const double x = 2 * std::cos(angle), y = std::sin(angle);
    const KirchhoffEllipse flow(level);
    const Velocity in = velocity(flow, x * (1 - 1e-12), y * (1 - 1e-12), 0);
    const Velocity out = velocity(flow, x * (1 + 1e-12), y * (1 + 1e-12), 0);
    EXPECT_NEAR(in[0], out[0], 1e-9);
    EXPECT_NEAR(in[1], out[1], 1e-9);
  }
}

/// Largest difference of the vortices' velocities from those that the other one induces, and from
/// the rate at which their places change.
double motion_error(const PointVortices& vortices, double factor = 1) {
  const VortexPair pair(vortices);
  constexpr double t = 0.7;
  double worst = 0;
  const auto now = pair.places(t), before = pair.places(t - step), after = pair.places(t + step);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::complex<double> apart = now[k] - now[1 - k];
    const std::complex<double> induced =
        std::complex<double>(0, factor * vortices.circulation[1 - k] / (2 * pi)) / std::conj(apart);
    worst = std::max(worst, std::abs((after[k] - before[k]) / (2 * step) - induced));
    const Table table = pair.of_particles(t);
    worst = std::max(worst, std::abs(table[2].values[k] - induced.real()));
    worst = std::max(worst, std::abs(table[3].values[k] - induced.imag()));
  }
  return worst;
}

TEST(VortexPair, MovesAsItsVorticesInduce) {
  for (const auto& strengths : {std::array{1.0, 1.0}, {1.0, -1.0}, {2.0, 0.5}, {1.5, -0.4}})
    EXPECT_LT(motion_error({strengths, {{{0.3, 0.1}, {-0.8, 0.4}}}}), 1e-8);
}

TEST(VortexPair, CheckNoticesAnotherStrength) {
  EXPECT_GT(motion_error({{1, 1}, {{{0.3, 0.1}, {-0.8, 0.4}}}}, 1.0001), 1e-6);
}

TEST(VortexPair, TurnsOnceInItsPeriodOrGoesStraightOn) {
  const double gamma = 3, d = 2, period = 2 * pi * pi * d * d / gamma;
  const VortexPair equal({{gamma, gamma}, {{{-1, 0}, {1, 0}}}});
  EXPECT_LT(std::abs(equal.places(period)[0] - std::complex<double>(-1, 0)), 1e-13);
  EXPECT_LT(std::abs(equal.places(period / 2)[0] - std::complex<double>(1, 0)), 1e-13);
  const VortexPair opposite({{gamma, -gamma}, {{{-1, 0}, {1, 0}}}});
  const std::complex<double> there(-1, 5 * gamma / (2 * pi * d));
  EXPECT_LT(std::abs(opposite.places(5)[0] - there), 1e-13);
}

}  // namespace
}  // namespace mote::test
