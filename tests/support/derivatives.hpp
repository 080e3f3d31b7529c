#pragma once

#include <vector>

#include "mote/operators/differential/apply.hpp"
#include "support/agreement.hpp"
#include "support/brute_force.hpp"

namespace mote::test {

/// What an operator makes of a scalar and a vector field, at every receiver. There is no curl on a
/// line.
struct Derivatives {
  std::vector<double> gradient, divergence, laplacian, curl, hessian;
};

/// Number of components of the curl.
template <int D>
inline constexpr std::size_t curl_size = D == 1 ? 0 : (D == 2 ? 1 : 3);

/// Applies `op` to `scalar` (one number a point) and `vector` (D numbers a point), with these
/// neighbours.
template <int D>
Derivatives derivatives_of(DifferentialOperator<D>& op, const Points<D>& points,
                           const NeighbourLists& lists, const std::vector<double>& scalar,
                           const std::vector<double>& vector) {
  const auto receivers = static_cast<std::size_t>(points.receivers);
  Derivatives result{std::vector<double>(receivers * D), std::vector<double>(receivers),
                     std::vector<double>(receivers), std::vector<double>(receivers * curl_size<D>),
                     std::vector<double>(receivers * D * D)};
  op.prepare(points, lists);
  gradient<D>(op, lists, scalar, result.gradient);
  divergence<D>(op, lists, vector, result.divergence);
  laplacian<D>(op, lists, scalar, result.laplacian);
  hessian<D>(op, lists, scalar, result.hessian);
  if constexpr (D > 1) curl<D>(op, lists, vector, result.curl);
  return result;
}

/// The same with neighbours found by brute force.
template <int D>
Derivatives derivatives_of(DifferentialOperator<D>& op, const Points<D>& points,
                           const std::vector<double>& scalar, const std::vector<double>& vector) {
  return derivatives_of(op, points, brute_force(points, op.neighbour_rule()), scalar, vector);
}

/// Whether every derivative equals its reference to within `tolerance`, as in `agree`.
template <int D, class Reference>
testing::AssertionResult all_agree(const Derivatives& found, const Reference& expected,
                                   double tolerance) {
  const auto check = [&](const char* name, const auto& values, const auto& reference) {
    const auto result = agree(values, reference, tolerance);
    return result ? result : testing::AssertionFailure() << name << ": " << result.message();
  };
  if (auto right = check("gradient", found.gradient, expected.gradient); !right) return right;
  if (auto right = check("divergence", found.divergence, expected.divergence); !right) return right;
  if (auto right = check("Laplacian", found.laplacian, expected.laplacian); !right) return right;
  if (auto right = check("Hessian", found.hessian, expected.hessian); !right) return right;
  return D == 1 ? testing::AssertionSuccess() : check("curl", found.curl, expected.curl);
}

/// Whether none of the derivatives equals its reference to within `tolerance`.
template <int D, class Reference>
testing::AssertionResult none_agrees(const Derivatives& found, const Reference& expected,
                                     double tolerance) {
  const bool any = agree(found.gradient, expected.gradient, tolerance) ||
                   agree(found.divergence, expected.divergence, tolerance) ||
                   agree(found.laplacian, expected.laplacian, tolerance) ||
                   agree(found.hessian, expected.hessian, tolerance) ||
                   (D > 1 && agree(found.curl, expected.curl, tolerance));
  return any ? testing::AssertionFailure() << "a derivative agrees" : testing::AssertionSuccess();
}

}  // namespace mote::test
