#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mote/operators/cores/core.hpp"
#include "support/quadrature.hpp"

namespace mote::test {

/// What every vortex core promises, as checks that a test can also ask to fail.

template <int D>
inline constexpr double unit_sphere = (D == 2 ? 2 : 4) * std::numbers::pi;

/// q(rho).
template <int D, class Core>
double within(double rho) {
  return std::pow(rho, D) * Core::template influence<D>(rho * rho);
}

/// q'(rho) by the density.
template <int D, class Core>
double shell(double rho) {
  return unit_sphere<D> * std::pow(rho, D - 1) * Core::template blob<D>(rho * rho);
}

inline testing::AssertionResult near(double found, double expected, double tolerance) {
  if (std::abs(found - expected) <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << found << " instead of " << expected << ", off by " << found - expected;
}

/// The moment int rho^power dq, over all space by rho = u/(1 - u).
template <int D, class Core>
double moment(int power) {
  return static_cast<double>(panel_integral(
      [&](long double u) {
        const auto rho = static_cast<double>(u / (1 - u));
        return std::pow(rho, power) * shell<D, Core>(rho) / ((1 - u) * (1 - u));
      },
      0, 1));
}

/// Calls check(rho) for a range of places until one fails.
template <class Check>
testing::AssertionResult at_all_places(Check check) {
  for (double rho = 0.05; rho < 30; rho *= 1.06)
    if (const auto result = check(rho); !result)
      return testing::AssertionFailure() << "at rho = " << rho << ": " << result.message();
  return testing::AssertionSuccess();
}

/// The five-point central difference of f at rho.
template <class Function>
double slope_of(Function f, double rho) {
  const double e = 1e-3 * std::min(rho, 1.0);
  return (8 * (f(rho + e) - f(rho - e)) - (f(rho + 2 * e) - f(rho - 2 * e))) / (12 * e);
}

template <int D, class Core>
testing::AssertionResult blob_is_slope_of_circulation() {
  return at_all_places(
      [](double rho) { return near(shell<D, Core>(rho), slope_of(within<D, Core>, rho), 1e-9); });
}

template <int D, class Core>
testing::AssertionResult influence_slope_is_derivative() {
  const auto influence = [](double rho) { return Core::template influence<D>(rho * rho); };
  return at_all_places([&](double rho) {
    const double scale = Core::template influence_slope<D>(0.0);
    return near(rho * Core::template influence_slope<D>(rho * rho), slope_of(influence, rho),
                1e-9 * std::abs(scale));
  });
}

/// q/rho in 2D, -q/rho^2 in 3D.
template <int D, class Core>
testing::AssertionResult potential_has_the_slope_of_influence() {
  const auto potential = [](double rho) { return Core::template potential<D>(rho * rho); };
  return at_all_places([&](double rho) {
    const double slope = rho * Core::template influence<D>(rho * rho);
    return near(D == 2 ? slope : -slope, slope_of(potential, rho),
                1e-9 * Core::template influence<D>(0.0));
  });
}

/// ln rho in 2D, 1/rho in 3D.
template <int D, class Core>
testing::AssertionResult potential_is_a_points_far_away() {
  const double rho = 1e5, point = D == 2 ? std::log(rho) : 1 / rho;
  return near(Core::template potential<D>(rho * rho), point, 1e-14 * point);
}

/// |1 - q| + rho |q'|, what the reach is about.
template <int D, class Core>
double deviation(double rho) {
  return std::abs(1 - within<D, Core>(rho)) + std::abs(rho * shell<D, Core>(rho));
}

/// No more than the tolerance from the reach on, and more not far inside.
template <int D, class Core>
testing::AssertionResult reach_is_right() {
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double reach = Core::template reach<D>(tolerance);
    for (const double factor : {1.0, 1.01, 1.3, 2.0, 10.0})
      if (!(deviation<D, Core>(factor * reach) < tolerance + 2e-15))
        return testing::AssertionFailure() << "too short for " << tolerance << ": " << reach;
    if (deviation<D, Core>(0.7 * reach) < tolerance)
      return testing::AssertionFailure() << "too long for " << tolerance << ": " << reach;
  }
  return testing::AssertionSuccess();
}

/// For eight numbers at a time as for one.
template <int D, class Core>
testing::AssertionResult lanes_equal_numbers() {
  const auto compare = [](auto of) {
    for (double start = 0; start < 100; start += 0.37) {
      const Lanes place([&](auto lane) { return start * (1 + 0.3 * lane); });
      const Lanes found = of(place);
      for (std::size_t k = 0; k < lane_count; ++k) {
        const double alone = of(static_cast<double>(place[k]));
        if (!std::isfinite(alone) || found[k] != alone) return false;
      }
    }
    return true;
  };
  const bool right = compare([](const auto& t) { return Core::template influence<D>(t); }) &&
                     compare([](const auto& t) { return Core::template influence_slope<D>(t); }) &&
                     compare([](const auto& t) { return Core::template blob<D>(t); }) &&
                     compare([](const auto& t) { return Core::template potential<D>(t); });
  return right ? testing::AssertionSuccess() : testing::AssertionFailure() << "they differ";
}

}  // namespace mote::test
