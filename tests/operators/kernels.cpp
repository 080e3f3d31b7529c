#include "mote/operators/kernels/all.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "kernel_cases.hpp"
#include "kernel_checks.hpp"

namespace mote::test {
namespace {

template <class Case>
struct Kernel : testing::Test {
  static constexpr int dimension = Case::dimension;
  typename Case::Kernel kernel;
};
TYPED_TEST_SUITE(Kernel, KernelCases, KernelCaseName);

TYPED_TEST(Kernel, HasUnitIntegral) {
  EXPECT_TRUE(has_unit_integral<TestFixture::dimension>(this->kernel));
}
TYPED_TEST(Kernel, SlopeIsTheDerivativeOfValue) { EXPECT_TRUE(slope_is_derivative(this->kernel)); }
TYPED_TEST(Kernel, CurvatureIsTheSecondDerivativeOfValue) {
  EXPECT_TRUE(curvature_is_second_derivative(this->kernel));
}
TYPED_TEST(Kernel, IsContinuousAtTheCutoff) { EXPECT_TRUE(is_continuous_at_cutoff(this->kernel)); }
TYPED_TEST(Kernel, VanishesBeyondItsSupport) { EXPECT_TRUE(vanishes_beyond_support(this->kernel)); }
TYPED_TEST(Kernel, IsSmoothAtTheCentre) { EXPECT_TRUE(is_smooth_at_centre(this->kernel)); }

/// A Gaussian with its parts scaled by hand: 1 leaves them right.
struct TamperedGauss {
  double value_factor = 1, slope_factor = 1, curvature_factor = 1, cutoff = 8.5;

  double support() const { return cutoff; }
  double value(double q) const { return value_factor * Gauss<1>::value(q); }
  double slope_over_q(double q) const { return slope_factor * Gauss<1>::slope_over_q(q); }
  double curvature(double q) const { return curvature_factor * Gauss<1>::curvature(q); }
};

TEST(KernelChecks, AcceptTheRightGaussian) { expect_kernel<1>(TamperedGauss{}); }
TEST(KernelChecks, RejectAWrongNorm) {
  EXPECT_FALSE(has_unit_integral<1>(TamperedGauss{.value_factor = 1 + 1e-11}));
  EXPECT_FALSE(has_unit_integral<2>(Gauss<1>{}));
}
TEST(KernelChecks, RejectAWrongSlope) {
  EXPECT_FALSE(slope_is_derivative(TamperedGauss{.slope_factor = -1}));
  EXPECT_FALSE(slope_is_derivative(TamperedGauss{.slope_factor = 1 + 1e-6}));
}
TEST(KernelChecks, RejectAWrongCurvature) {
  EXPECT_FALSE(curvature_is_second_derivative(TamperedGauss{.curvature_factor = -1}));
  EXPECT_FALSE(curvature_is_second_derivative(TamperedGauss{.curvature_factor = 1 + 1e-6}));
  EXPECT_FALSE(is_smooth_at_centre(TamperedGauss{.slope_factor = 1.001}));
}
TEST(KernelChecks, RejectAKernelThatIsCutTooEarly) {
  EXPECT_FALSE(is_continuous_at_cutoff(TamperedGauss{.cutoff = 6}));
  EXPECT_FALSE(vanishes_beyond_support(TamperedGauss{.cutoff = 6}));
}

// The formulas of Table 3 of Isshiki (2014), in one dimension with a smoothing length of 1.
TEST(Gauss, IsTheWeightSph0OfTable3) {
  for (const double q : {0.0, 0.3, 1.0, 2.7, 6.0})
    EXPECT_NEAR(Gauss<1>::value(q), std::exp(-q * q / 2) / std::sqrt(2 * std::numbers::pi), 1e-16);
}

TEST(Lucy, IsTheWeightSph1OfTable3) {
  for (const double q : {0.0, 0.2, 0.5, 0.9, 1.0})
    EXPECT_NEAR(Lucy<1>::value(q), 5.0 / 4 * (1 + 3 * q) * std::pow(1 - q, 3), 1e-15);
}

TEST(CubicSpline, IsTheWeightSph2OfTable3) {
  for (const double q : {0.0, 0.2, 0.4999})
    EXPECT_NEAR(CubicSpline<1>::value(q), 4.0 / 3 * (1 - 6 * q * q + 6 * q * q * q), 1e-15);
  for (const double q : {0.5, 0.8, 1.0})
    EXPECT_NEAR(CubicSpline<1>::value(q), 4.0 / 3 * 2 * std::pow(1 - q, 3), 1e-15);
}

}  // namespace
}  // namespace mote::test
