// Finite differences at standing points against the exact solution, away from the ends: there the
// gas falls inwards and leaves a vacuum, and the zero gradient of (76) makes up gas that is not
// there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mote/exact/gravitating_sheets.hpp"
#include "mote/integrators/runge_kutta_4.hpp"
#include "support/altered_operator.hpp"
#include "support/line_gas.hpp"

namespace mote::test {
namespace {

constexpr double end = 3;

/// The exact density at places, between the particles of 10000 cells.
class ExactDensity {
 public:
  explicit ExactDensity(const LineGas& gas) {
    const PressurelessGas start = make_gas(gas, {.gravity = gas.gravity}, 10'000);
    const auto copy = [&](std::string_view field) {
      const auto values = start.cloud().values(field);
      return std::vector<double>(values.begin(), values.end());
    };
    table_ = GravitatingSheets({copy("position"), copy("velocity"), copy("length"),
                                copy("length_rate"), copy("mass"), 0, gas.gravity})
                 .of_particles(end);
  }

  double operator()(double place) const {
    const auto &x = table_[0].values, &rho = table_[2].values;
    const auto k = std::ranges::upper_bound(x, place) - x.begin();
    return std::lerp(rho[k - 1], rho[k], (place - x[k - 1]) / (x[k] - x[k - 1]));
  }

 private:
  Table table_;
};

/// L1 error of the density at the end on `count` standing points, relative to the exact density.
double density_error(const LineGas& gas, Index count, OperatorOnALine op,
                     const ExactDensity& exact) {
  PressurelessGas model = make_gas(gas, {.gravity = gas.gravity}, count, std::move(op));
  RungeKutta4 method;
  run(model, method, end, count);
  const auto x = model.cloud().position(), rho = model.cloud().values("density");
  double error = 0, norm = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[i] - 2) > 1.4) continue;
    error += std::abs(rho[i] - exact(x[i]));
    norm += exact(x[i]);
  }
  return error / norm;
}

/// Errors on `count` points and on twice, four times, ... as many.
template <class MakeOperator>
std::vector<double> refinement(const LineGas& gas, Index count, int levels, MakeOperator make) {
  const ExactDensity exact(gas);
  std::vector<double> errors;
  for (int level = 0; level < levels; ++level, count *= 2)
    errors.push_back(density_error(gas, count, make(count), exact));
  return errors;
}

OperatorOnALine finite_difference(Index) { return std::make_unique<FiniteDifference<1>>(); }

using AlteredDifference = AlteredOperator<1, FiniteDifference<1>>;

/// An operator that is wrong at one point, by half of one weight.
OperatorOnALine wrong_at_one_point(Index count) {
  return std::make_unique<AlteredDifference>(FiniteDifference<1>(), 2 * count / 5, 0.5);
}

/// An operator that is wrong everywhere, by a fiftieth of one weight.
OperatorOnALine wrong_everywhere(Index) {
  return std::make_unique<AlteredDifference>(FiniteDifference<1>(), std::nullopt, 0.02);
}

/// Whether the mean order over all refinements is `order`, to 0.15, each refinement helps, and the
/// last error is at most `ceiling`.
testing::AssertionResult has_order(const std::vector<double>& errors, double order,
                                   double ceiling) {
  const double observed =
      std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
  const bool falls = std::ranges::is_sorted(errors, std::greater<>());
  if (falls && std::abs(observed - order) <= 0.15 && errors.back() <= ceiling)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "order " << observed << ", last error " << errors.back();
}

LineGas cosine() {
  return {"cosine", 0.0015,
          [](double x) { return 0.6 - 0.5 * std::cos(std::numbers::pi * x / 2); }};
}

// At the kinks of the trapezoid central differences leave waves, which cost an order.
TEST(FiniteDifferenceAtStandingPoints, HasOrderOnePointTwoOnTheTrapezoid) {
  EXPECT_TRUE(has_order(refinement(trapezoid(), 80, 5, finite_difference), 1.2, 4e-4));
}

TEST(FiniteDifferenceAtStandingPoints, HasOrderTwoOnASmoothStart) {
  EXPECT_TRUE(has_order(refinement(cosine(), 40, 5, finite_difference), 2, 4e-6));
}

TEST(FiniteDifferenceAtStandingPoints, OrderChecksNoticeWrongOperators) {
  EXPECT_FALSE(has_order(refinement(trapezoid(), 80, 5, wrong_everywhere), 1.2, 4e-4));
  EXPECT_FALSE(has_order(refinement(cosine(), 40, 5, wrong_everywhere), 2, 4e-6));
  EXPECT_FALSE(has_order(refinement(cosine(), 40, 5, wrong_at_one_point), 2, 4e-6));
}

}  // namespace
}  // namespace mote::test
