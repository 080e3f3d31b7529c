#include "mote/integrators/hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mote::test {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

/// Value and derivatives of (t - 1)^power, the last over 2 times itself.
std::vector<double> power_at(double time, int power) {
  const double s = time - 1;
  return {std::pow(s, power), power * std::pow(s, power - 1),
          power * (power - 1) * std::pow(s, power - 2)};
}

HermiteWeights weights_of(const std::vector<double>& times, int derivatives, double time) {
  std::vector<HermiteNode> nodes;
  for (const double node : times) nodes.push_back({node, derivatives});
  return HermiteWeights(nodes, time);
}

/// The larger error in value and rate of the polynomial of (t - 1)^power, whose tangents at the
/// nodes are multiplied by a number.
double error(const std::vector<double>& times, int derivatives, int power, double tangent = 1) {
  const double time = 2.25;
  const HermiteWeights weights = weights_of(times, derivatives, time);
  double value = 0, rate = 0;
  for (std::size_t node = 0; node < times.size(); ++node) {
    std::vector<double> known = power_at(times[node], power);
    known[1] *= tangent;
    for (int order = 0; order <= derivatives; ++order) {
      value += weights.at(node)[order].value * known[order];
      rate += weights.at(node)[order].rate * known[order];
    }
  }
  const auto exact = power_at(time, power);
  return std::max(std::abs(value - exact[0]), std::abs(rate - exact[1]));
}

const std::vector<double> two{1.75, 2.5}, three{1.5, 1.75, 2.5}, four{1.125, 1.5, 1.75, 2.5};

TEST(Hermite, IsExactForPolynomialsOfItsDegree) {
  for (int power = 2; power <= 3; ++power) EXPECT_LE(error(two, 1, power), 50 * unit) << power;
  for (int power = 2; power <= 5; ++power) EXPECT_LE(error(two, 2, power), 50 * unit) << power;
  for (int power = 2; power <= 8; ++power) EXPECT_LE(error(three, 2, power), 500 * unit) << power;
  for (int power = 2; power <= 11; ++power) EXPECT_LE(error(four, 2, power), 5000 * unit) << power;
}

TEST(Hermite, IsNotExactForTheNextPowerNorWithWrongTangents) {
  EXPECT_GT(error(two, 1, 4), 1e-4);
  EXPECT_GT(error(two, 2, 6), 1e-5);
  EXPECT_GT(error(three, 2, 9), 1e-5);
  EXPECT_GT(error(four, 2, 12), 1e-6);
  EXPECT_GT(error(two, 1, 3, 1.001), 1e-4);
  EXPECT_GT(error(four, 2, 11, 1.001), 1e-4);
}

/// Rehman 2014, 1.1.3, at tau = 1/3 of a step H = 0.75.
TEST(Hermite, HasTheWeightsOfTheDirectForm) {
  const double H = two[1] - two[0], tau = 1.0 / 3, rest = 1 - tau;
  const HermiteWeights quintic = weights_of(two, 2, two[0] + tau * H);
  EXPECT_NEAR(quintic.at(0)[0].value, std::pow(rest, 3) * (6 * tau * tau + 3 * tau + 1), unit);
  EXPECT_NEAR(quintic.at(0)[1].value, H * std::pow(rest, 3) * tau * (3 * tau + 1), unit);
  EXPECT_NEAR(quintic.at(0)[2].value, H * H * std::pow(rest, 3) * tau * tau / 2, unit);
  EXPECT_NEAR(quintic.at(1)[1].value, H * std::pow(tau, 3) * rest * (3 * tau - 4), unit);
  const HermiteWeights cubic = weights_of(two, 1, two[0] + tau * H);
  EXPECT_NEAR(cubic.at(0)[0].value, rest * rest * (2 * tau + 1), unit);
  EXPECT_NEAR(cubic.at(1)[1].value, H * tau * tau * (tau - 1), unit);
}

TEST(Hermite, IsTheNodeAtANode) {
  for (std::size_t at = 0; at < 4; ++at) {
    const HermiteWeights weights = weights_of(four, 2, four[at]);
    EXPECT_EQ(weights.nearest(), at);
    for (std::size_t node = 0; node < 4; ++node)
      for (int order = 0; order <= 2; ++order) {
        EXPECT_EQ(weights.at(node)[order].value, node == at && order == 0);
        EXPECT_EQ(weights.at(node)[order].rate, node == at && order == 1);
      }
  }
}

TEST(Hermite, HasWeightsOfValuesThatAddToOneFarFromTheOrigin) {
  const std::vector<double> late{1e6, 1e6 + 0.001, 1e6 + 0.002, 1e6 + 0.003};
  const HermiteWeights weights = weights_of(late, 2, 1e6 + 0.0024);
  double sum = 0, slope = 0, size = 0;
  for (std::size_t node = 0; node < 4; ++node) {
    sum += weights.at(node)[0].value;
    slope += weights.at(node)[0].rate;
    size += std::abs(weights.at(node)[0].rate);
  }
  EXPECT_NEAR(sum, 1, 4 * unit);
  EXPECT_NEAR(slope, 0, unit * size);
}

}  // namespace
}  // namespace mote::test
