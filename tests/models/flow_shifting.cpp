// Particle shifting in a weakly compressible flow: where it moves particles, what they carry along,
// and the volume that it keeps.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "support/flow_case.hpp"

namespace mote::test {
namespace {

/// Root mean square distance of the particles to their nearest neighbours' mean, in spacings, and
/// the smallest distance of two.
std::pair<double, double> distances(const WeaklyCompressible<2>& flow, double spacing,
                                    double width) {
  std::vector<double> nearest;
  const Index count = flow.cloud().count();
  for (Index i = 0; i < count; ++i) {
    double least = width;
    for (Index j = 0; j < count; ++j) {
      Vec<2> x = vector_of(flow, "position", i) - vector_of(flow, "position", j);
      for (int d = 0; d < 2; ++d) x[d] -= width * std::round(x[d] / width);
      if (j != i) least = std::min(least, x.norm());
    }
    nearest.push_back(least / spacing);
  }
  const double mean =
      std::accumulate(nearest.begin(), nearest.end(), 0.0) / static_cast<double>(count);
  double spread = 0;
  for (const double distance : nearest) spread += std::pow(distance - mean, 2);
  return {std::sqrt(spread / static_cast<double>(count)), std::ranges::min(nearest)};
}

/// A jittered box that streams through its periodic sides.
std::pair<double, double> distances_after_streaming(double shifting) {
  FlowCase flow = periodic_square(0.1, 1.2);
  flow.options.shifting = shifting;
  flow.velocity = [](const Place&) { return Triple{1}; };
  const auto made = make_flow<2>(in_disorder(flow, 0.25));
  run(*made, 0.2, 100);
  return distances(*made, 0.1, 1.2);
}

TEST(Shifting, MakesParticlesMoreRegular) {
  const auto [spread, closest] = distances_after_streaming(0);  // the negative control
  const auto [shifted_spread, shifted_closest] = distances_after_streaming(1);
  EXPECT_LT(shifted_spread, 0.5 * spread);
  EXPECT_GT(shifted_closest, closest + 0.1);
}

Mat<2> slopes() { return (Mat<2>() << 0.3, -0.8, 0.5, -0.3).finished(); }

/// Particles in disorder in a field u = A x + bend (x^2 + y^2), of linear density, moved by
/// shifting alone: the largest error of the velocity they carry.
std::array<double, 3> error_after_shifting(double bend, double step) {
  FlowCase flow = flow_in_a_box(2, 0.1, {1, 1});
  flow.options.shifting = 1;
  flow.options.free_surface = false;
  const auto velocity = [=](const Vec<2>& x) -> Vec<2> {
    return slopes() * x + bend * x.squaredNorm() * Vec<2>::Ones();
  };
  flow.velocity = [=](const Place& at) {
    const Vec<2> u = velocity({at[0], at[1]});
    return Triple{u[0], u[1]};
  };
  flow.pressure = [](const Place& at) { return 20 * at[0] - 10 * at[1]; };
  flow.options.divergence = Derivatives::by_operator;  // pairs add the crowding's change
  const auto made = make_flow<2>(in_disorder(flow, 0.25));
  made->longest_step(0, 0.2);
  const auto before = made->cloud();
  made->end_step(0, step);
  const Index count = made->cloud().count();
  const auto error = [&](Index i) -> Vec<2> {
    return vector_of(*made, "velocity", i) - velocity(vector_of(*made, "position", i));
  };
  // What all gain alike is taken back, so that momentum stays.
  Vec<2> common = Vec<2>::Zero();
  for (Index i = 0; i < count; ++i) common += error(i) / count;
  std::array<double, 3> found{};
  for (Index i = 0; i < count; ++i) {
    const Vec<2> x = vector_of(*made, "position", i);
    const double off = (error(i) - common).norm();
    const double density = 1 + (20 * x[0] - 10 * x[1]) / 100;
    const Vec<2> moved = x - Vec<2>::Map(before.position().data() + std::ptrdiff_t{i} * 2);
    found[0] = std::max(found[0], off);
    found[1] = std::max(found[1], std::abs(made->cloud().values("density")[i] - density));
    found[2] = std::max(found[2], moved.norm());
  }
  return found;
}

TEST(Shifting, LeavesLinearFieldsAsTheyAre) {
  const auto [velocity, density, moved] = error_after_shifting(0, 0.003);
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(velocity, 1e-13);
  EXPECT_LT(density, 1e-13);
}

/// The error of a field that bends goes with the way times the spacing at least: it is of first
/// order in the shift, and not 0 (a negative control of the test above).
TEST(Shifting, CarriesFieldsThatBendAsFarAsTheirSlopes) {
  const auto coarse = error_after_shifting(1, 2e-4), fine = error_after_shifting(1, 1e-4);
  EXPECT_GT(fine[0], 1e-8);
  EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 1, 0.2);
}

/// Particles in disorder in a periodic box, all of the same velocity and density.
struct EvenDisorder {
  static constexpr double spacing = 0.1, width = 1.2, mass = spacing * spacing;
  double length;  ///< smoothing length
  std::unique_ptr<WeaklyCompressible<2>> flow;

  explicit EvenDisorder(bool free_surface, Derivatives divergence = Derivatives::pairs) {
    FlowCase given = periodic_square(spacing, width);
    given.options.shifting = 1;
    given.options.free_surface = free_surface;
    given.options.divergence = divergence;
    given.velocity = [](const Place&) { return Triple{1}; };
    length = given.smoothing_length * spacing;
    flow = make_flow<2>(in_disorder(given, 0.25));
    flow->longest_step(0, 0.2);
  }

  Vec<2> place(Index i) const { return vector_of(*flow, "position", i); }
  Vec<2> between(Index i, Index j) const {
    const Vec<2> x = place(i) - place(j);
    return x - width * (x / width).array().round().matrix();
  }
  double density(Index i) const { return flow->cloud().values("density")[i]; }

  /// sum V_j grad W_ij
  Vec<2> imbalance(Index i) const {
    Vec<2> sum = Vec<2>::Zero();
    for (Index j = 0; j < flow->cloud().count(); ++j)
      if (j != i) sum += WendlandC2<2>::slope_over_q(between(i, j).norm() / length) * between(i, j);
    return mass / std::pow(length, 4) * sum;
  }

  /// Sum over all particles of the density by summation, up to a constant.
  double crowd() const {
    double sum = 0;
    for (Index i = 0; i < flow->cloud().count(); ++i)
      for (Index j = 0; j < i; ++j) sum += 2 * WendlandC2<2>::value(between(i, j).norm() / length);
    return mass * sum / std::pow(length, 2);
  }

  double sum_of_densities() const {
    const auto density = flow->cloud().values("density");
    return std::accumulate(density.begin(), density.end(), 0.0);
  }
};

/// The largest deviations of shifts from the way of `imbalance`, relative, and of the densities'
/// changes from 2 rho times the product of both.
std::pair<double, double> deviations_of_shifts(bool free_surface) {
  EvenDisorder box(free_surface);
  const Index count = box.flow->cloud().count();
  std::vector<Vec<2>> before, imbalance;
  for (Index i = 0; i < count; ++i) {
    before.push_back(box.place(i));
    imbalance.push_back(box.imbalance(i));
  }
  box.flow->end_step(0, 1e-5);
  double astray = 0, off = 0, most = 0;
  for (Index i = 0; i < count; ++i) {
    const Vec<2> way = box.place(i) - before[i], back = -imbalance[i];
    astray = std::max(astray, (way / way.norm() - back / back.norm()).norm());
    const double change = 2 * way.dot(imbalance[i]);
    off = std::max(off, std::abs(box.density(i) - 1 - change));
    most = std::max(most, std::abs(change));
  }
  return {astray, off / most};
}

TEST(Shifting, GoesAgainstTheImbalanceAndDensityFollows) {
  const auto [astray, off] = deviations_of_shifts(false);
  EXPECT_LT(astray, 1e-6);
  EXPECT_LT(off, 1e-6);
}

/// Negative control: with a free surface close pairs count more, and densities stay.
TEST(Shifting, DiffersWithAFreeSurface) {
  const auto [astray, off] = deviations_of_shifts(true);
  EXPECT_GT(astray, 0.01);
  EXPECT_GT(off, 0.5);
}

/// What densities lose by a shift, over what the particles' crowd loses.
double loss_over_crowd(Derivatives divergence) {
  EvenDisorder box(false, divergence);
  const double densities = box.sum_of_densities(), crowd = box.crowd();
  box.flow->end_step(0, 1e-5);
  EXPECT_GT(crowd - box.crowd(), 1e-5);
  return (densities - box.sum_of_densities()) / (crowd - box.crowd());
}

TEST(Shifting, TakesFromDensitiesWhatItTakesFromTheCrowd) {
  EXPECT_NEAR(loss_over_crowd(Derivatives::pairs), 1, 1e-3);
  // Negative control: without pairs nothing had been added to the densities.
  EXPECT_NEAR(loss_over_crowd(Derivatives::by_operator), 0, 1e-6);
}

/// Of the fluid, in units of its particles' mass.
double volume_of(const WeaklyCompressible<2>& flow) {
  double sum = 0;
  for (Index i = 0; i < flow.cloud().count(); ++i)
    if (flow.walls()[static_cast<std::size_t>(i)] == 0)
      sum += 1 / flow.cloud().values("density")[i];
  return sum;
}

/// How much the volume of a fluid that is stirred between its periodic sides changes, relatively.
double change_of_volume(bool free_surface) {
  FlowCase flow = periodic_square(0.1, 1.2);
  flow.options.shifting = 1;
  flow.options.free_surface = free_surface;
  flow.velocity = [](const Place& at) {
    const double k = 2 * std::numbers::pi / 1.2;
    return Triple{std::sin(k * at[0]) * std::cos(k * at[1]),
                  -std::cos(k * at[0]) * std::sin(k * at[1])};
  };
  const auto made = make_flow<2>(in_disorder(flow, 0.2));
  const double before = volume_of(*made);
  run(*made, 0.2, 100);
  return std::abs(volume_of(*made) / before - 1);
}

TEST(Shifting, KeepsTheVolumeOfWhatFillsItsSpace) {
  EXPECT_LT(change_of_volume(false), 1e-13);
  EXPECT_GT(change_of_volume(true), 1e-4);  // the negative control
}

/// The same between walls of which one moves in at this speed, or drags alone.
double change_of_volume_by_piston(double speed, bool travels) {
  FlowCase flow = flow_in_a_box(2, 0.05, {1, 1});
  flow.options.shifting = 1;
  flow.options.free_surface = false;
  with_wall(flow, 0, false,
            {.velocity = [=](double) { return Triple{speed}; }, .travels = travels});
  with_wall(flow, 0, true);
  with_wall(flow, 1, false);
  with_wall(flow, 1, true);
  const auto made = make_flow<2>(flow);
  const double before = volume_of(*made);
  run(*made, 0.4, 200);
  return volume_of(*made) / before - 1;
}

TEST(Shifting, LetsAPistonCompress) {
  EXPECT_NEAR(change_of_volume_by_piston(0.05, true), -0.02, 0.001);
  EXPECT_LT(std::abs(change_of_volume_by_piston(0.05, false)), 1e-13);  // the negative control
}

}  // namespace
}  // namespace mote::test
