#include "mote/xivas/matrix_exponentials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "mote/xivas/spectral_exponentials.hpp"
#include "xivas/precise.hpp"

namespace mote {
namespace {

/// The largest error of P, Q and R in units of eps max(1, conditioning).
template <int D>
double worst_error(const MatrixExponentials<double, D>& found,
                   const Eigen::Matrix<double, D, D>& a) {
  const auto b = precise::of<D>(a);
  const auto exact = precise::exponentials<D>(b);
  const auto conditioning = precise::conditioning<D>(b);
  const Eigen::Matrix<double, D, D> results[] = {found.p, found.q, found.r};
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const auto difference = precise::multiply_add<D>(
        precise::scaled<D>(exact[k], -1), precise::identity<D>(), precise::of<D>(results[k]));
    worst = std::max(worst, precise::norm<D>(difference) / precise::norm<D>(exact[k]) /
                                std::max(1.0, conditioning[k]));
  }
  return worst / std::numeric_limits<double>::epsilon();
}

/// Random entries of sizes from 1e-8 to 40, with rotation, decay to -50, or neither.
template <int D>
Eigen::Matrix<double, D, D> random_matrix(std::mt19937_64& random, int kind) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::Matrix<double, D, D> a;
  const double size = std::pow(10.0, -3 + 4.5 * unit(random));
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) a(i, j) = size * unit(random);
  if (kind % 4 == 1) a = Eigen::Matrix<double, D, D>(a - a.transpose());
  if (kind % 4 == 2) a -= (45 + 5 * unit(random)) * a.Identity();
  if (kind % 4 == 3)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < i; ++j) a(i, j) = 0;
  return a;
}

template <int D>
double worst_of_random() {
  std::mt19937_64 random(7);
  double worst = 0;
  for (int n = 0; n < 60; ++n) {
    const auto a = random_matrix<D>(random, n);
    worst = std::max(worst, worst_error<D>(matrix_exponentials<double, D>(a, 1.0), a));
  }
  return worst;
}

TEST(MatrixExponentials, AreRightToAFewRoundingsTimesTheirConditioning) {
  const double plane = worst_of_random<2>(), space = worst_of_random<3>();
  EXPECT_LT(plane, 10);
  EXPECT_LT(space, 10);
  RecordProperty("worst_2", std::to_string(plane));
  RecordProperty("worst_3", std::to_string(space));
}

TEST(MatrixExponentials, OfShortTimesKeepEveryDigit) {
  Eigen::Matrix3d a;
  a << 1, 2, -1, 0.5, -3, 2, 1, 1, 0.25;
  const double t = 0x1p-60;
  const auto of = matrix_exponentials<double, 3>(a, t);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_DOUBLE_EQ(of.q(i, j), i == j ? t : t * t / 2 * a(i, j));
      EXPECT_DOUBLE_EQ(of.r(i, j), i == j ? t * t / 2 : t * t * t / 6 * a(i, j));
    }
}

TEST(MatrixExponentials, OfARotationTurn) {
  Eigen::Matrix2d a;
  a << 0, -1, 1, 0;
  const auto of = matrix_exponentials<double, 2>(a, 0.75);
  EXPECT_NEAR(of.p(0, 0), std::cos(0.75), 2e-16);
  EXPECT_NEAR(of.p(1, 0), std::sin(0.75), 2e-16);
  EXPECT_NEAR(of.q(1, 0), 1 - std::cos(0.75), 2e-16);
  EXPECT_NEAR(of.r(1, 0), 0.75 - std::sin(0.75), 2e-16);
}

TEST(SpectralExponentials, AgreeWhereThePaperSaysSo) {
  Eigen::Matrix3d pair, real;
  Eigen::Matrix2d plane;
  pair << 0.1, -0.2, 1, 0.2, 0.1, 1, 0, 0, 0.4;
  real << 0.1, 1, 1, 0, 0.2, 1, 0, 0, 0.3;
  plane << 0.3, 1, -2, 0.1;
  EXPECT_LT(worst_error<3>(spectral_exponentials<3>(pair, 1, SpectralScheme::piecewise), pair),
            1e5);
  EXPECT_LT(worst_error<3>(spectral_exponentials<3>(real, 1, SpectralScheme::piecewise), real),
            1e5);
  EXPECT_LT(worst_error<2>(spectral_exponentials<2>(plane, 1, SpectralScheme::piecewise), plane),
            1e3);
}

TEST(SpectralExponentials, LoseEveryDigitOfStrongDecay) {
  Eigen::Matrix3d a;
  a << -50, 1, 0, 0, -49, 1, 0.5, 0, -48;
  EXPECT_GT(worst_error<3>(spectral_exponentials<3>(a, 1, SpectralScheme::piecewise), a), 1e12);
  EXPECT_LT(worst_error<3>(matrix_exponentials<double, 3>(a, 1.0), a), 10);
}

TEST(SpectralExponentials, AsUsualAreSpoiledNearEqualEigenvalues) {
  const double h = 1e-6;
  Eigen::Matrix3d a;
  a << h, 1, 1, 0, 2 * h, 1, 0, 0, 3 * h;
  EXPECT_GT(worst_error<3>(spectral_exponentials<3>(a, 1, SpectralScheme::usual), a), 1e10);
  EXPECT_LT(worst_error<3>(spectral_exponentials<3>(a, 1, SpectralScheme::piecewise), a), 10);
}

}  // namespace
}  // namespace mote
