// Burgers' case of Isshiki (2014), (88), (89), on moving points: velocities of material points
// against the exact ones, root mean square over the particles, at t = 2.5.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "mote/exact/burgers_cole_hopf.hpp"
#include "mote/integrators/velocity_verlet.hpp"
#include "support/altered_operator.hpp"
#include "support/line_gas.hpp"

namespace mote::test {
namespace {

constexpr double end = 2.5, viscosity = 0.02;

/// What the exact solution says of particles that start in the middles of `count` cells.
const Table& exact(Index count) {
  static std::map<Index, Table> known;
  if (const auto found = known.find(count); found != known.end()) return found->second;
  const LineGas gas = flat_slope_flat();
  const Cells cells = cells_of_line<Regular>(0, gas.upper, count, 0);
  const BurgersColeHopf solution(
      {gas.velocity, gas.density, cells.centre, 0, gas.upper, viscosity});
  return known.emplace(count, solution.of_particles(end)).first->second;
}

struct Outcome {
  double velocity_error, peak_density;
};

Outcome outcome(OperatorOnALine op, Index count) {
  PressurelessGas gas =
      make_gas(flat_slope_flat(), {.viscosity = viscosity, .frame = FrameChoice::lagrangian}, count,
               std::move(op));
  VelocityVerlet verlet;
  run(gas, verlet, end, 1000);
  gas.inspect();
  const auto u = gas.cloud().values("velocity");
  double sum = 0;
  for (Index i = 0; i < count; ++i) sum += std::pow(u[i] - exact(count)[1].values[i], 2);
  return {std::sqrt(sum / count), std::ranges::max(gas.cloud().values("density"))};
}

double order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

OperatorOnALine three_points() { return std::make_unique<FiniteDifference<1>>(); }

TEST(Burgers, ThreePointsOnMovingParticlesConvergeToTheExactSolution) {
  const std::map<Index, double> limits{{41, 2.5e-3}, {81, 6e-4}, {161, 1.6e-4}, {321, 4e-5}};
  std::optional<std::pair<Index, double>> coarser;
  for (const auto& [count, limit] : limits) {
    const Outcome found = outcome(three_points(), count);
    EXPECT_LE(found.velocity_error, limit) << count;
    if (coarser) {
      const auto [last_count, last_error] = *coarser;
      const double observed =
          order(last_error, found.velocity_error, static_cast<double>(count) / last_count);
      EXPECT_GE(observed, 1.9) << count;
      EXPECT_LE(observed, 2.2) << count;
    }
    coarser = {count, found.velocity_error};
    if (count == 321) {
      EXPECT_NEAR(found.peak_density, 134.919, 0.005 * 134.919);
    }
  }
}

TEST(Burgers, CheckNoticesAWeightThatIsOnePercentOff) {
  const auto altered = [](Index count) {
    return outcome(std::make_unique<AlteredOperator<1, FiniteDifference<1>>>(FiniteDifference<1>(),
                                                                             std::nullopt, 0.01),
                   count)
        .velocity_error;
  };
  EXPECT_LT(order(altered(81), altered(161), 161.0 / 81), 1.7);
}

struct Family {
  std::string name;
  OperatorOnALine (*make)();
  double finest_error;

  friend void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }
};

struct ParticleFamily : testing::TestWithParam<Family> {};

TEST_P(ParticleFamily, ConvergesWithOrderTwo) {
  double last = 0;
  for (const Index count : {41, 81, 161}) {
    const double error = outcome(GetParam().make(), count).velocity_error;
    if (last > 0) {
      EXPECT_GE(order(last, error, 161.0 / 81), 1.7);
      EXPECT_LE(order(last, error, 161.0 / 81), 2.2);
    }
    last = error;
  }
  EXPECT_LT(last, GetParam().finest_error);
}

INSTANTIATE_TEST_SUITE_P(
    , ParticleFamily,
    testing::Values(
        Family{"corrected_sph",
               []() -> OperatorOnALine { return std::make_unique<CorrectedSph<1, Gauss<1>>>(); },
               4e-4},
        Family{"morris",
               []() -> OperatorOnALine { return std::make_unique<Morris<1, Gauss<1>>>(); }, 7e-4},
        Family{"least_squares",
               []() -> OperatorOnALine { return std::make_unique<Quadratic<1>>(); }, 3e-4}),
    [](const auto& family) { return family.param.name; });

TEST(Burgers, IsNotWhatPrintedMpsConvergesTo) {
  const auto error = [](Index count) {
    auto op = std::make_unique<Mps<1>>();
    op->smoothing_length = 2;
    op->length = PairLength::gather;
    return outcome(std::move(op), count).velocity_error;
  };
  const double coarse = error(41), middle = error(81), fine = error(161);
  EXPECT_GT(fine, 0.05);
  EXPECT_NEAR(order(coarse, middle, 81.0 / 41), 0, 0.2);
  EXPECT_NEAR(order(middle, fine, 161.0 / 81), 0, 0.2);
}

}  // namespace
}  // namespace mote::test
