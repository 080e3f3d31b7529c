// Bodies drawn at random, against the distributions that they are to have.

#include "mote/models/clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/bodies_case.hpp"

namespace mote::test {
namespace {

constexpr std::int64_t many = 20000;

std::vector<double> lengths(const std::vector<double>& vectors) {
  std::vector<double> found;
  for (std::size_t k = 0; k < vectors.size(); k += 3)
    found.push_back(std::hypot(vectors[k], vectors[k + 1], vectors[k + 2]));
  return found;
}

/// Kolmogorov's statistic: the largest difference between the part of values below each and what a
/// distribution says, times the root of their number. Above 1.95 in one of 1000 cases by chance.
double kolmogorov(std::vector<double> values, const std::function<double(double)>& part_below) {
  std::ranges::sort(values);
  const auto count = static_cast<double>(values.size());
  double worst = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double expected = part_below(values[k]);
    worst = std::max({worst, std::abs(expected - static_cast<double>(k) / count),
                      std::abs(expected - static_cast<double>(k + 1) / count)});
  }
  return worst * std::sqrt(count);
}

/// Part of a Plummer sphere's mass within r, of what is within ten scale radii.
double plummer_part(double r, double scale = 1) {
  const auto within = [](double x) { return std::pow(x * x / (1 + x * x), 1.5); };
  return within(r / scale) / within(10);
}

TEST(PlummerSphere, HasItsDensityProfile) {
  const auto bodies = sampled<3>(plummer(many), 1);
  EXPECT_LT(kolmogorov(lengths(bodies.position), [](double r) { return plummer_part(r); }), 1.95);
  EXPECT_GT(kolmogorov(lengths(bodies.position), [](double r) { return plummer_part(r, 1.05); }),
            1.95);  // negative control
}

/// <v^2> r.m.s. of each speed over what is expected at its radius, <v^2> = G M/(2 sqrt(r^2 + a^2))
/// with the mass of the whole sphere: its mean over the bodies less 1, in standard errors.
double dispersion_deviation(const MassList<3>& bodies, double constant) {
  const auto r = lengths(bodies.position), v = lengths(bodies.velocity);
  const double whole = constant / plummer_mass_within(10);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double ratio = v[i] * v[i] / (whole / (2 * std::hypot(r[i], 1)));
    sum += ratio;
    squares += ratio * ratio;
  }
  const auto count = static_cast<double>(r.size());
  const double mean = sum / count, variance = squares / count - mean * mean;
  return (mean - 1) / std::sqrt(variance / count);
}

TEST(PlummerSphere, HasItsDispersionOfVelocities) {
  const auto bodies = sampled<3>(plummer(many), 2);
  EXPECT_LT(std::abs(dispersion_deviation(bodies, 2)), 3.3);
  EXPECT_GT(std::abs(dispersion_deviation(bodies, 2.1)), 3.3);  // negative control
}

/// Part of the speeds below q times that of escape: the integral of q^2 (1 - q^2)^n over that to 1.
double part_of_speeds(double q, double n) {
  const auto integral = [n](double end) {
    constexpr int pieces = 200;
    double sum = 0;
    for (int k = 0; k < pieces; ++k) {
      const double x = end * (k + 0.5) / pieces;
      sum += x * x * std::pow(1 - x * x, n) * end / pieces;
    }
    return sum;
  };
  return integral(q) / integral(1);
}

TEST(PlummerSphere, HasTheSpeedsOfItsDistributionFunction) {
  const auto bodies = sampled<3>(plummer(2000), 1);
  const auto r = lengths(bodies.position), v = lengths(bodies.velocity);
  const double whole = 1 / plummer_mass_within(10);
  std::vector<double> part;
  for (std::size_t i = 0; i < r.size(); ++i)
    part.push_back(v[i] / std::sqrt(2 * whole / std::hypot(r[i], 1)));
  EXPECT_LT(kolmogorov(part, [](double q) { return part_of_speeds(q, 3.5); }), 1.95);
  EXPECT_GT(kolmogorov(part, [](double q) { return part_of_speeds(q, 3); }), 1.95);
}

TEST(PlummerSphere, IsInVirialEquilibrium) {
  const auto bodies = make_bodies<3>({.clusters = {plummer(many)}});
  // Kinetic energies scatter by about their own size: twice 1/sqrt(N) and that of the virial.
  EXPECT_NEAR(told(*bodies, "virial_ratio"), 1, 4 / std::sqrt(static_cast<double>(many)));
  const auto stronger =
      make_bodies<3>({.gravitational_constant = 1.1, .clusters = {plummer(many)}});
  EXPECT_NEAR(told(*stronger, "virial_ratio"), told(*bodies, "virial_ratio"), 1e-6);
}

/// Negative control: places of one gravity with the velocities of another.
TEST(PlummerSphere, IsNotWithTheVelocitiesOfAnotherGravity) {
  const auto bodies = make_bodies<3>({.clusters = {plummer(many)}});
  for (double& component : bodies->cloud().values("velocity")) component *= 1.05;
  EXPECT_GT(told(*bodies, "virial_ratio"), 1 + 4 / std::sqrt(static_cast<double>(many)));
}

TEST(UniformBall, IsUniformAndAtRest) {
  const auto bodies = sampled<3>(uniform_ball(many), 1);
  const auto cube = [](double r) { return std::pow(r, 3); };
  // The ball's own centre of mass is 1/sqrt(N) away from that of its bodies, which changes radii
  // by less than chance does.
  EXPECT_LT(kolmogorov(lengths(bodies.position), [&](double r) { return std::min(1.0, cube(r)); }),
            1.95);
  EXPECT_GT(kolmogorov(lengths(bodies.position), [](double r) { return std::min(1.0, r * r); }),
            1.95);
  EXPECT_EQ(std::ranges::max(lengths(bodies.velocity)), 0);
}

TEST(Clusters, HaveTheirMassCentreAndVelocity) {
  for (Cluster cluster : {plummer(1000, 3), uniform_ball(1000, 3)}) {
    cluster.mass = 7;
    cluster.centre = {1, 2, 3};
    cluster.velocity = {-1, 0.5, 0};
    const auto bodies = sampled<3>(cluster, 1);
    double mass = 0;
    Vec<3> centre = Vec<3>::Zero(), drift = Vec<3>::Zero();
    for (std::size_t i = 0; i < bodies.count(); ++i) {
      mass += bodies.mass[i];
      centre += Vec<3>::Map(&bodies.position[3 * i]) / 1000;
      drift += Vec<3>::Map(&bodies.velocity[3 * i]) / 1000;
    }
    EXPECT_NEAR(mass, 7, 1e-12);
    EXPECT_LT((centre - Vec<3>(1, 2, 3)).norm(), 1e-13);
    EXPECT_LT((drift - Vec<3>(-1, 0.5, 0)).norm(), 1e-13);
  }
}

TEST(Clusters, DependOnTheSeedAlone) {
  EXPECT_EQ(sampled<3>(plummer(100, 1), 1).position, sampled<3>(plummer(100, 1), 1).position);
  EXPECT_NE(sampled<3>(plummer(100, 1), 1).position, sampled<3>(plummer(100, 2), 1).position);
}

}  // namespace
}  // namespace mote::test
