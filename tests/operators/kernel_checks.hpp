#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/quadrature.hpp"

namespace mote::test {

/// What every kernel promises, as checks that a test can also ask to fail.

template <int D, class Kernel>
testing::AssertionResult has_unit_integral(const Kernel& kernel) {
  const auto value = [&](long double q) { return kernel.value(static_cast<double>(q)); };
  const long double integral = radial_integral<D>(value, kernel.support());
  if (std::abs(integral - 1) <= 1e-12L) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the integral is 1 + " << integral - 1;
}

/// Compares exact(q) with approximate(q, step) in the middle of each of 60 parts of the support:
/// break points lie between parts. `scale` is what the difference is measured against.
template <class Kernel, class Exact, class Approximate>
testing::AssertionResult agree_inside(const Kernel& kernel, Exact exact, Approximate approximate,
                                      double scale) {
  constexpr int parts = 60;
  const double step = 1e-3 * kernel.support();
  for (int part = 0; part < parts; ++part) {
    const double q = (part + 0.5) / parts * kernel.support();
    const double difference = exact(q) - approximate(q, step);
    if (!(std::abs(difference) <= 1e-8 * scale))
      return testing::AssertionFailure()
             << "at q = " << q << " it is " << exact(q) << ", the difference " << difference;
  }
  return testing::AssertionSuccess();
}

/// q slope_over_q against the five-point central difference of value.
template <class Kernel>
testing::AssertionResult slope_is_derivative(const Kernel& kernel) {
  const auto w = [&](double q) { return kernel.value(q); };
  return agree_inside(
      kernel, [&](double q) { return q * kernel.slope_over_q(q); },
      [&](double q, double e) {
        return (8 * (w(q + e) - w(q - e)) - (w(q + 2 * e) - w(q - 2 * e))) / (12 * e);
      },
      kernel.value(0) / std::min(1.0, kernel.support()));
}

/// curvature against the five-point second difference of value.
template <class Kernel>
testing::AssertionResult curvature_is_second_derivative(const Kernel& kernel) {
  const auto w = [&](double q) { return kernel.value(q); };
  return agree_inside(
      kernel, [&](double q) { return kernel.curvature(q); },
      [&](double q, double e) {
        return (16 * (w(q + e) + w(q - e)) - (w(q + 2 * e) + w(q - 2 * e)) - 30 * w(q)) /
               (12 * e * e);
      },
      kernel.value(0) / std::min(1.0, kernel.support() * kernel.support()));
}

/// Value and slope at the rim, against those at the centre.
template <class Kernel>
testing::AssertionResult is_continuous_at_cutoff(const Kernel& kernel) {
  const double rim = kernel.support();
  const double value = std::abs(kernel.value(rim) / kernel.value(0));
  const double slope = std::abs(kernel.slope_over_q(rim) / kernel.slope_over_q(0));
  if (value <= 1e-15 && slope <= 1e-15) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "value " << value << " and slope " << slope << " remain";
}

template <class Kernel>
testing::AssertionResult vanishes_beyond_support(const Kernel& kernel) {
  for (const double factor : {1 + 1e-9, 1.001, 1.5, 10.0, 1e9}) {
    const double q = factor * kernel.support();
    if (kernel.value(q) != 0 || kernel.slope_over_q(q) != 0 || kernel.curvature(q) != 0)
      return testing::AssertionFailure() << "something is left at q = " << q;
  }
  return testing::AssertionSuccess();
}

/// slope_over_q is finite at the centre, and there equals the curvature: both are W''(0).
template <class Kernel>
testing::AssertionResult is_smooth_at_centre(const Kernel& kernel) {
  const double slope = kernel.slope_over_q(0), curvature = kernel.curvature(0);
  if (std::isfinite(slope) && std::abs(slope - curvature) <= 1e-14 * std::abs(curvature))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "slope/q " << slope << ", curvature " << curvature;
}

/// All of the above.
template <int D, class Kernel>
void expect_kernel(const Kernel& kernel) {
  EXPECT_TRUE(has_unit_integral<D>(kernel));
  EXPECT_TRUE(slope_is_derivative(kernel));
  EXPECT_TRUE(curvature_is_second_derivative(kernel));
  EXPECT_TRUE(is_continuous_at_cutoff(kernel));
  EXPECT_TRUE(vanishes_beyond_support(kernel));
  EXPECT_TRUE(is_smooth_at_centre(kernel));
}

}  // namespace mote::test
