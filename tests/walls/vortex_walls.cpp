#include "mote/walls/vortex_walls.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>

#include "walls/exact_flows.hpp"

namespace mote::test {
namespace {

using Release = WallDiffusion::Release;

/// A cylinder of radius 1 that a stream (1, 0) meets at once; Reynolds number 2/nu. Velocities are
/// summed over pairs, with algebraic cores of fourth order and 0.7 spacings.
struct StartedCylinder {
  StartedCylinder(double reynolds, double spacing, double step)
      : StartedCylinder(reynolds, spacing, step,
                        {circle_outline(0, 1, 4 * static_cast<Index>(0.65 / spacing))}) {}
  StartedCylinder(double reynolds, double spacing, double step, const std::vector<Outline>& bodies)
      : step_(step),
        core2_(0.49 * spacing * spacing),
        walls(bodies, {.spacing = spacing, .viscosity = 2 / reynolds}) {
    for (std::size_t k = 0; k < walls.bodies().panels().size(); ++k) {
      stream_.push_back(1);
      stream_.push_back(0);
    }
  }

  std::vector<double> velocity(const std::vector<double>& position) const {
    std::vector<double> result(position.size());
    for (std::size_t i = 0; i < circulation.size(); ++i) {
      double u = 1, v = 0;
      for (std::size_t j = 0; j < circulation.size(); ++j) {
        const double x = position[2 * i] - position[2 * j];
        const double y = position[2 * i + 1] - position[2 * j + 1];
        const double r2 = x * x + y * y, scale = 1 / (r2 + core2_);
        const double factor = circulation[j] / (2 * pi) * (r2 + 2 * core2_) * scale * scale;
        u -= factor * y;
        v += factor * x;
      }
      result[2 * i] = u;
      result[2 * i + 1] = v;
    }
    walls.add_velocity({position, circulation}, stream_, position, result);
    return result;
  }

  std::vector<double> moved(const std::vector<double>& velocity, double time) const {
    std::vector<double> result = position;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += time * velocity[k];
    return result;
  }

  void advance() {
    walls.begin_step({position, circulation}, stream_);
    position = moved(velocity(moved(velocity(position), step_ / 2)), step_);
    const Release release = time == 0 ? Release::at_start : Release::evenly;
    auto after = walls.end_step({position, circulation}, stream_, step_, release);
    position = std::move(after.position);
    circulation = std::move(after.circulation);
    time += step_;
  }

  /// D/(rho U^2 R), at the middle of the last step.
  double drag() const { return walls.force()[0]; }
  double middle() const { return time - step_ / 2; }

  double step_, core2_;
  VortexWalls walls;
  std::vector<double> stream_, position, circulation;
  double time = 0;
};

/// Of the drag coefficient at early times from 4 sqrt(2 pi/(Re T)), half of it friction.
double largest_error(StartedCylinder& cylinder, double reynolds) {
  double largest = 0;
  while (cylinder.time < 0.1) {
    cylinder.advance();
    if (cylinder.middle() < 0.03) continue;
    const double theory = 4 * std::sqrt(2 * pi / (reynolds * cylinder.middle()));
    largest = std::max(largest, std::abs(cylinder.drag() / theory - 1));
  }
  return largest;
}

TEST(VortexWalls, DragOfACylinderThatStartsAtOnce) {
  StartedCylinder cylinder(1000, 0.0125, 0.01);
  EXPECT_LT(largest_error(cylinder, 1000), 0.03);
  const auto [x, y] = cylinder.walls.force_on(0);
  EXPECT_NEAR(x, cylinder.drag(), 0.03 * cylinder.drag());
  EXPECT_NEAR(y, 0, 1e-11);
  EXPECT_NEAR(cylinder.walls.force()[1], 0, 1e-11);
}

/// Negative control: another viscosity is noticed.
TEST(VortexWalls, DragOfACylinderTellsTheViscosity) {
  StartedCylinder cylinder(1200, 0.0125, 0.01);
  EXPECT_GT(largest_error(cylinder, 1000), 0.05);
}

double root_mean_square(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Of the slip that a step leaves at time 0.6, where the fluid would slip by 2 sin theta.
double slip_left(double spacing, double step) {
  StartedCylinder cylinder(200, spacing, step);
  while (cylinder.time < 0.6 - step / 2) cylinder.advance();
  return root_mean_square(cylinder.walls.slip());
}

TEST(VortexWalls, LittleSlipIsLeftAndLessOnAFinerLattice) {
  const double coarse = slip_left(0.08, 0.06), fine = slip_left(0.04, 0.03);
  EXPECT_LT(fine, 0.01);
  EXPECT_LT(fine, coarse / 1.5);
}

TEST(VortexWalls, CirculationIsKeptOutsideTheBody) {
  StartedCylinder cylinder(200, 0.08, 0.06);
  for (int n = 0; n < 10; ++n) cylinder.advance();
  double sum = cylinder.walls.bodies().circulation(cylinder.walls.slip(), 0);
  for (const double circulation : cylinder.circulation) sum += circulation;
  EXPECT_NEAR(sum, 0, 1e-13);
  EXPECT_GT(std::abs(cylinder.walls.lost().impulse), 0);
  for (std::size_t k = 0; k < cylinder.circulation.size(); ++k)
    EXPECT_GT(std::hypot(cylinder.position[2 * k], cylinder.position[2 * k + 1]), 1);
}

TEST(VortexWalls, SameBitsForAnyNumberOfThreads) {
  const int threads_before = omp_get_max_threads();
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    StartedCylinder cylinder(200, 0.06, 0.05);
    for (int n = 0; n < 4; ++n) cylinder.advance();
    results.push_back(cylinder.position);
    results.back().insert(results.back().end(), cylinder.circulation.begin(),
                          cylinder.circulation.end());
    results.back().push_back(cylinder.drag());
  }
  omp_set_num_threads(threads_before);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

/// One behind the other: each has its force, and both together the loss of impulse.
TEST(VortexWalls, ForcesOnBodiesSumToTheLossOfImpulse) {
  const double spacing = 0.08, step = 0.06;
  StartedCylinder flow(200, spacing, step,
                       {circle_outline(0, 1, 32), circle_outline({2.6, 0.5}, 0.7, 24)});
  for (int n = 0; n < 12; ++n) flow.advance();
  const auto first = flow.walls.force_on(0), second = flow.walls.force_on(1);
  const auto sum = flow.walls.force();
  EXPECT_NEAR(first[0] + second[0], sum[0], 0.05 * sum[0]);
  EXPECT_NEAR(first[1] + second[1], sum[1], 0.05 * sum[0]);
}

/// A vortex beside a cylinder in a fluid without friction goes round it: at (r, 0) with its image
/// inside and none in the middle, as the sheet's circulation is minus its own.
TEST(VortexWalls, AVortexCirclesACylinder) {
  const VortexWalls walls(std::vector{circle_outline(0, 1, 256)}, {.spacing = 0.02});
  const std::vector<double> stream(walls.panel_places().size()), place{1.5, 0}, circulation{2};
  std::vector<double> velocity(2);
  walls.add_velocity({place, circulation}, stream, place, velocity);
  const double image = -2 / (2 * pi * (1.5 - 1 / 1.5));
  EXPECT_NEAR(velocity[0], 0, 1e-4);
  EXPECT_NEAR(velocity[1], image, 2e-3 * std::abs(image));
}

}  // namespace
}  // namespace mote::test
