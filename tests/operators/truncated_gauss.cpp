#include "mote/operators/kernels/truncated_gauss.hpp"

#include <gtest/gtest.h>

#include "kernel_checks.hpp"
#include "support/quadrature.hpp"
#include "support/settings.hpp"

namespace mote::test {
namespace {

template <class Kernel>
Kernel with_cutoff(double cutoff) {
  Kernel kernel;
  Settings().with("cutoff", cutoff).apply_to(kernel);
  return kernel;
}

/// (90a), (92a) and (92b) of Isshiki (2014) in the paper's letters, and alpha from (91).
struct Printed {
  long double h, gamma = 1, alpha = 1;

  long double bell(long double x) const { return alpha * std::exp(-x * x / (2 * gamma * gamma)); }
  long double w(long double x) const {
    return bell(x) * (1 - 2 * x * x / (h * h) + x * x * x * x / (h * h * h * h));
  }
  long double slope(long double x) const {
    const long double h2 = h * h, h4 = h2 * h2, g2 = gamma * gamma;
    return bell(x) * (-(4 / h2 + 1 / g2) * x + (4 / h4 + 2 / (g2 * h2)) * std::pow(x, 3) -
                      std::pow(x, 5) / (g2 * h4));
  }
  long double curvature(long double x) const {
    const long double h2 = h * h, h4 = h2 * h2, g2 = gamma * gamma, g4 = g2 * g2;
    return bell(x) *
           (-(4 / h2 + 1 / g2) + (12 / h4 + 10 / (g2 * h2) + 1 / g4) * x * x -
            (9 / (g2 * h4) + 2 / (g4 * h2)) * std::pow(x, 4) + std::pow(x, 6) / (g4 * h4));
  }
};

template <int D>
Printed printed(long double h) {
  Printed weight{.h = h};
  weight.alpha = 1 / radial_integral<D>([&](long double x) { return weight.w(x); }, h);  // (91)
  return weight;
}

/// Whether value, slope and curvature are the printed ones, to 1e-13 of their size at the centre.
template <class Kernel>
testing::AssertionResult is_printed(const Kernel& kernel, const Printed& weight) {
  for (int k = 1; k <= 100; ++k) {
    const double x = k / 100.0 * kernel.support();
    const long double value = kernel.value(x) - weight.w(x);
    const long double slope = x * kernel.slope_over_q(x) - weight.slope(x);
    const long double curvature = kernel.curvature(x) - weight.curvature(x);
    if (std::max({std::abs(value), std::abs(slope), std::abs(curvature)}) > 1e-13L * weight.w(0))
      return testing::AssertionFailure() << "at x = " << x << " the differences are " << value
                                         << ", " << slope << ", " << curvature;
  }
  return testing::AssertionSuccess();
}

struct TruncatedGaussCutoff : testing::TestWithParam<double> {};

TEST_P(TruncatedGaussCutoff, HasThePrintedDerivatives) {
  EXPECT_TRUE(is_printed(with_cutoff<TruncatedGauss<1>>(GetParam()), printed<1>(GetParam())));
  EXPECT_TRUE(is_printed(with_cutoff<TruncatedGauss<2>>(GetParam()), printed<2>(GetParam())));
  EXPECT_TRUE(is_printed(with_cutoff<TruncatedGauss<3>>(GetParam()), printed<3>(GetParam())));
}

TEST_P(TruncatedGaussCutoff, CheckRejectsAnotherCutoffOrNorm) {
  const auto kernel = with_cutoff<TruncatedGauss<1>>(GetParam());
  EXPECT_FALSE(is_printed(kernel, printed<1>(GetParam() * (1 + 1e-9))));
  EXPECT_FALSE(is_printed(kernel, printed<2>(GetParam())));
  Printed wrong = printed<1>(GetParam());
  wrong.gamma = 1 + 1e-9;
  EXPECT_FALSE(is_printed(kernel, wrong));
}

TEST_P(TruncatedGaussCutoff, KeepsThePromisesOfAKernel) {
  expect_kernel<1>(with_cutoff<TruncatedGauss<1>>(GetParam()));
  expect_kernel<2>(with_cutoff<TruncatedGauss<2>>(GetParam()));
  expect_kernel<3>(with_cutoff<TruncatedGauss<3>>(GetParam()));
}

TEST_P(TruncatedGaussCutoff, OfTheCosineWindowKeepsThePromisesOfAKernel) {
  expect_kernel<1>(with_cutoff<TruncatedGaussCosine<1>>(GetParam()));
  expect_kernel<2>(with_cutoff<TruncatedGaussCosine<2>>(GetParam()));
  expect_kernel<3>(with_cutoff<TruncatedGaussCosine<3>>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(, TruncatedGaussCutoff, testing::Values(2.0, 4.0, 8.0),
                         testing::PrintToStringParamName());

TEST(TruncatedGauss, HasUnitIntegralForEveryCutoffItAccepts) {
  for (const double cutoff : {0.1, 0.5, 1.0, 20.0, 100.0}) {
    EXPECT_TRUE(has_unit_integral<1>(with_cutoff<TruncatedGauss<1>>(cutoff))) << cutoff;
    EXPECT_TRUE(has_unit_integral<3>(with_cutoff<TruncatedGauss<3>>(cutoff))) << cutoff;
    EXPECT_TRUE(has_unit_integral<2>(with_cutoff<TruncatedGaussCosine<2>>(cutoff))) << cutoff;
  }
}

// At the rim the curvature jumps; a neighbour there gets the value from inside (ERRATA on (90)).
TEST(TruncatedGauss, CountsTheRimAsInside) {
  const auto kernel = with_cutoff<TruncatedGauss<1>>(2);
  const double inner = static_cast<double>(printed<1>(2).curvature(2));
  EXPECT_GT(inner, 0.01);
  EXPECT_NEAR(kernel.curvature(2), inner, 1e-14);
  EXPECT_NEAR(kernel.curvature(2 * (1 + 1e-14)), inner, 1e-12);
}

}  // namespace
}  // namespace mote::test
