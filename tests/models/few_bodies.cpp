#include "mote/models/few_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mote/models/own_gravity.hpp"

namespace mote::test {
namespace {

/// Masses on irregular places.
struct Masses {
  std::vector<double> mass, position;
};

template <int D>
Masses scattered(std::size_t count) {
  Masses bodies;
  for (std::size_t k = 0; k < count * D; ++k)
    bodies.position.push_back(std::sin(1.7 * static_cast<double>(k * k)));
  for (std::size_t k = 0; k < count; ++k)
    bodies.mass.push_back(1 + 0.5 * std::cos(static_cast<double>(k)));
  return bodies;
}

/// sum_j G m_j (x_j - x_i)/r^D, literally.
template <int D>
std::vector<double> literal_sum(double constant, const Masses& bodies) {
  std::vector<double> sum(bodies.position.size());
  for (std::size_t i = 0; i < bodies.mass.size(); ++i)
    for (std::size_t j = 0; j < bodies.mass.size(); ++j) {
      double square = 0;
      for (std::size_t d = 0; d < D; ++d)
        square += std::pow(bodies.position[D * j + d] - bodies.position[D * i + d], 2);
      if (square == 0) continue;
      for (std::size_t d = 0; d < D; ++d)
        sum[D * i + d] += constant * bodies.mass[j] *
                          (bodies.position[D * j + d] - bodies.position[D * i + d]) /
                          std::pow(square, 0.5 * D);
    }
  return sum;
}

/// Largest difference from the literal sum, over the largest component.
template <int D>
double error(const Masses& bodies, double constant) {
  std::vector<double> result(bodies.position.size());
  few_bodies::accelerate<D>(0.7, bodies.mass, bodies.position, result);
  const auto exact = literal_sum<D>(constant, bodies);
  double worst = 0, largest = 1e-300;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    worst = std::max(worst, std::abs(result[k] - exact[k]));
    largest = std::max(largest, std::abs(exact[k]));
  }
  return worst / largest;
}

constexpr std::size_t counts[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 17, 63, 64};

TEST(FewBodies, AttractEachOtherByTheLiteralSum) {
  for (const std::size_t count : counts) {
    EXPECT_LT(error<2>(scattered<2>(count), 0.7), 2e-15) << count;
    EXPECT_LT(error<3>(scattered<3>(count), 0.7), 2e-15) << count;
    if (count > 1) {
      EXPECT_GT(error<3>(scattered<3>(count), 0.7 + 1e-12), 1e-13) << count;
    }
  }
}

TEST(FewBodies, DoNothingToOneOnTheirOwnPlace) {
  for (const std::size_t count : {3, 12}) {
    Masses bodies = scattered<3>(count);
    for (std::size_t d = 0; d < 3; ++d) bodies.position[d] = bodies.position[6 + d];
    EXPECT_LT(error<3>(bodies, 0.7), 2e-15);
  }
}

/// The same whether few or many: the sum for many is taken where one more is beyond the few.
TEST(FewBodies, AreThoseOfTheSumForMany) {
  for (const std::size_t count : {few_bodies::most, few_bodies::most + 1}) {
    const Masses bodies = scattered<3>(count);
    OwnGravity<3> gravity(0.7, {});
    std::vector<double> result(3 * count);
    gravity.accelerate({bodies.position, bodies.mass, 0}, result);
    const auto exact = literal_sum<3>(0.7, bodies);
    for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(result[k], exact[k], 1e-13 * count);
  }
}

}  // namespace
}  // namespace mote::test
