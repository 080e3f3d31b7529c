// ContEvol on bodies under their own gravity, and the power series of that gravity.
#include "mote/integrators/contevol.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mote/integrators/conservation_correction.hpp"
#include "mote/integrators/runge_kutta_8.hpp"
#include "mote/models/gravity_series.hpp"
#include "support/bodies_case.hpp"
#include "support/few_bodies.hpp"
#include "support/typed_lists.hpp"

namespace mote::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Two bodies on an ellipse, or a rosette in the plane; their centre of mass moves.
template <int D>
struct TwoBodies : FewBodies<D> {
  explicit TwoBodies(double first_mass = 0.7)
      : FewBodies<D>({first_mass, 1 - first_mass}, vectors(first_mass, {1, 0}, {0.2, 0.1}),
                     vectors(first_mass, {0.6, 0.9}, {-0.1, 0.4})) {}

  VectorXd relative() const {
    VectorXd result(2 * D);
    for (int d = 0; d < D; ++d) {
      result[d] = this->position[D + d] - this->position[d];
      result[D + d] = this->velocity[D + d] - this->velocity[d];
    }
    return result;
  }

 private:
  static std::vector<double> vectors(double first_mass, std::array<double, 2> relative,
                                     std::array<double, 2> centre) {
    std::vector<double> result(2 * D, 0.0);
    for (std::size_t d = 0; d < 2; ++d) {
      result[d] = centre[d] - (1 - first_mass) * relative[d];
      result[D + d] = centre[d] + first_mass * relative[d];
    }
    return result;
  }
};

template <class Method, class System>
void take(Method& method, System& system, int steps, double step) {
  for (int k = 0; k < steps; ++k) method.advance_one_step(system, k * step, step);
}

/// Before the separation has its largest value: where the radial velocity is 0, the corrected
/// methods' errors go through a root.
constexpr double end = 1;

/// The state of two bodies at the end by a method whose error is that of rounding.
template <int D>
VectorXd reference() {
  TwoBodies<D> system;
  RungeKutta8 method;
  take(method, system, 500, end / 500);
  return system.relative();
}

template <class Method, int D>
double error_after(int steps) {
  static const VectorXd exact = reference<D>();
  TwoBodies<D> system;
  Method method;
  take(method, system, steps, end / steps);
  return (system.relative() - exact).norm();
}

/// Whether the observed order is `order` to 0.15 twice, and the finest error at most step^order,
/// with steps at which errors of this order lie well above rounding.
template <class Method, int D>
testing::AssertionResult has_order(int order) {
  const int coarsest = Method::order == 4 ? 60 : 15;
  double coarser = error_after<Method, D>(coarsest);
  for (const int steps : {2 * coarsest, 4 * coarsest}) {
    const double error = error_after<Method, D>(steps);
    const double observed = std::log2(coarser / error);
    if (!(std::abs(observed - order) <= 0.15))
      return testing::AssertionFailure() << "order " << observed << " at " << steps << " steps";
    coarser = error;
  }
  const double ceiling = std::pow(end / (4 * coarsest), order);
  if (coarser <= ceiling) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "error " << coarser << ", ceiling " << ceiling;
}

template <class Method>
struct ContEvolOrder : testing::Test {};
using Methods =
    testing::Types<ContEvol1, ContEvol1Corrected, ContEvol2Direct, ContEvol2DirectCorrected,
                   ContEvol2Indirect, ContEvol2IndirectCorrected>;
TYPED_TEST_SUITE(ContEvolOrder, Methods, NameOfType);

TYPED_TEST(ContEvolOrder, IsObservedInSpaceAndInThePlane) {
  EXPECT_TRUE((has_order<TypeParam, 3>(TypeParam::order)));
  EXPECT_TRUE((has_order<TypeParam, 2>(TypeParam::order)));
}

TYPED_TEST(ContEvolOrder, CheckRejectsTheOrdersBesideIt) {
  EXPECT_FALSE((has_order<TypeParam, 3>(TypeParam::order - 1)));
  EXPECT_FALSE((has_order<TypeParam, 3>(TypeParam::order + 1)));
}

TYPED_TEST(ContEvolOrder, GoesOnFromItsMemoryToTheSameBits) {
  TwoBodies<3> system, restarted;
  TypeParam method, before, after;
  take(method, system, 20, 0.1);
  EXPECT_TRUE(after.memory().empty());
  take(before, restarted, 10, 0.1);
  method.forget_rounding();
  system.position = restarted.position;
  system.velocity = restarted.velocity;
  after.recall(before.memory());
  take(method, system, 10, 0.1);
  take(after, restarted, 10, 0.1);
  EXPECT_EQ(system.position, restarted.position);
  EXPECT_EQ(system.velocity, restarted.velocity);
}

/// The masses count in the squares, so that the errors of forces between bodies do not move their
/// centre of mass.
TYPED_TEST(ContEvolOrder, KeepsTotalMomentum) {
  TwoBodies<3> system(0.9);
  TypeParam method;
  take(method, system, 100, 0.1);
  EXPECT_NEAR(0.9 * system.velocity[0] + 0.1 * system.velocity[3], -0.1, 1e-15);
  EXPECT_NEAR(0.9 * system.velocity[1] + 0.1 * system.velocity[4], 0.4, 1e-15);
}

/// Relative motion depends on the sum of the masses alone, also where one of them is 0.
TYPED_TEST(ContEvolOrder, MovesTestParticles) {
  const auto moved = [](double first_mass) {
    TwoBodies<3> system(first_mass);
    TypeParam method;
    take(method, system, 10, 0.1);
    return system.relative();
  };
  EXPECT_LE((moved(1) - moved(0.5)).norm(), 1e-14);
  EXPECT_LE((moved(0) - moved(0.5)).norm(), 1e-14);
  EXPECT_LE((moved(0.8) - moved(0.5)).norm(), 1e-14);
}

/// A step's path goes from its start to its end, and its middle is as good as a step.
TYPED_TEST(ContEvolOrder, HasAPath) {
  constexpr double step = 0.05;
  TwoBodies<3> start, system, exact;
  TypeParam method;
  RungeKutta8 reference;
  take(method, system, 1, step);
  take(reference, exact, 10, step / 20);
  const VectorXd stop = system.relative();
  ASSERT_TRUE(method.has_path());
  method.go_along_path(system, 0);
  EXPECT_LE((system.relative() - start.relative()).norm(), 1e-15);
  method.go_along_path(system, 1);
  EXPECT_LE((system.relative() - stop).norm(), 1e-15);
  method.go_along_path(system, 0.5);
  EXPECT_LE((system.relative() - exact.relative()).norm(), std::pow(step, 4));
  EXPECT_GT((system.relative() - exact.relative()).norm(), 0);
}

template <int D>
double energy_and_momentum_error(const FewBodies<D>& system, const FewBodies<D>& start) {
  const auto kept = [](const FewBodies<D>& s) {
    const double x = s.position[D] - s.position[0], y = s.position[D + 1] - s.position[1];
    const double u = s.velocity[D] - s.velocity[0], v = s.velocity[D + 1] - s.velocity[1];
    const double r = std::hypot(x, y), potential = D == 2 ? std::log(r) : -1 / r;
    return Eigen::Vector2d((u * u + v * v) / 2 + potential, x * v - y * u);
  };
  return (kept(system) - kept(start)).norm();
}

template <class Method, int D>
double lost_after(int steps) {
  TwoBodies<D> system, start;
  Method method;
  take(method, system, steps, 0.1);
  return energy_and_momentum_error(system, start);
}

TEST(ConservationCorrection, KeepsEnergyAndAngularMomentum) {
  EXPECT_LE((lost_after<ContEvol1Corrected, 3>(1000)), 1e-14);
  EXPECT_LE((lost_after<ContEvol1Corrected, 2>(1000)), 1e-14);
  EXPECT_GT((lost_after<ContEvol1, 3>(1000)), 1e-6);
}

TEST(ConservationCorrection, IsForTwoPointMasses) {
  const std::string two = "two point masses, for its conservation correction";
  FewBodies<3> three({1, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 1, 0}, std::vector<double>(9));
  FewBodies<3> massless({0, 0}, {0, 0, 0, 1, 0, 0}, std::vector<double>(6));
  TwoBodies<3> right;
  EXPECT_EQ(ContEvol1Corrected().missing_in(three), two);
  EXPECT_EQ(ContEvol1().missing_in(three), "");
  EXPECT_EQ(ContEvol1Corrected().missing_in(massless), two);
  EXPECT_EQ(ContEvol1Corrected().missing_in(right), "");
}

TEST(ContEvol, RefusesManyBodies) {
  FewBodies<3> many(std::vector<double>(101, 1.0), std::vector<double>(303),
                    std::vector<double>(303));
  EXPECT_EQ(ContEvol1().missing_in(many),
            "few bodies, 300 coordinates at most, for its equations are dense");
}

TEST(ContEvol, MovesTheBodiesOfAScenario) {
  const auto bodies = make_bodies<3>(
      {.masses = {{0.7, {-0.1, 0, 0}, {-0.28, 0.13, 0}}, {0.3, {0.9, 0, 0}, {0.32, 1.03, 0}}}});
  FewBodies<3> alike({0.7, 0.3}, {-0.1, 0, 0, 0.9, 0, 0}, {-0.28, 0.13, 0, 0.32, 1.03, 0});
  ContEvol2Direct method;
  take_steps(*bodies, ContEvol2Direct(), 10, 0.1);
  take(method, alike, 10, 0.1);
  EXPECT_EQ(
      std::vector<double>(bodies->cloud().position().begin(), bodies->cloud().position().end()),
      alike.position);
  BodiesOptions soft{.core = "algebraic.2", .core_size = 0.1};
  soft.masses = {{.mass = 1, .position = {0, 0, 0}, .velocity = {}}};
  EXPECT_EQ(make_bodies<3>(soft)->force_series(), nullptr);
}

/// The series along a cubic path against the values at places on it.
template <int D>
void expect_series_of_gravity() {
  const std::vector<double> mass{1, 0, 0.4};
  GravitySeries<D> gravity(0.7, mass);
  std::vector<VectorXd> path;
  for (int k = 0; k < 4; ++k) {
    path.emplace_back(3 * D);
    for (int i = 0; i < 3 * D; ++i) path[k][i] = std::sin(1.0 + 2.3 * i + 1.7 * k);
  }
  std::vector<VectorXd> force(24);
  std::vector<MatrixXd> derivative(24);
  gravity.expand(path, force, derivative);
  constexpr double t = 0.05;
  VectorXd place = VectorXd::Zero(3 * D), sum = place, value;
  MatrixXd slope_sum = MatrixXd::Zero(3 * D, 3 * D);
  for (int k = 0; k < 4; ++k) place += std::pow(t, k) * path[k];
  for (int k = 0; k < 24; ++k) {
    sum += std::pow(t, k) * force[k];
    slope_sum += std::pow(t, k) * derivative[k];
  }
  gravity.expand({&place, 1}, {&value, 1}, {});
  EXPECT_LE((sum - value).norm(), 1e-12 * value.norm());
  for (int i = 0; i < 3 * D; ++i) {
    constexpr double difference = 1e-5;
    VectorXd up, down, there = place;
    there[i] += difference;
    gravity.expand({&there, 1}, {&up, 1}, {});
    there[i] -= 2 * difference;
    gravity.expand({&there, 1}, {&down, 1}, {});
    const VectorXd expected = (up - down) / (2 * difference);
    EXPECT_LE((slope_sum.col(i) - expected).norm(), 1e-8 * slope_sum.norm()) << i;
  }
}

TEST(GravitySeries, AddsUpToTheForceAlongAPath) {
  expect_series_of_gravity<2>();
  expect_series_of_gravity<3>();
}

}  // namespace
}  // namespace mote::test
