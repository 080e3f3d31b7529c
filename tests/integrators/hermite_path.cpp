#include "mote/integrators/hermite_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kepler_problem.hpp"
#include "mote/integrators/paths.hpp"
#include "mote/particles/failure.hpp"
#include "support/typed_lists.hpp"

namespace mote::test {
namespace {

/// Largest errors of position and velocity, once the path has all its nodes.
struct Errors {
  double position = 0, velocity = 0;
};

/// Of a circle once round, in this many steps whose ends are exact but for what `spoil` does.
template <class SomePath, class Spoil>
Errors errors_on_circle(int steps, Spoil spoil) {
  KeplerProblem system(0);
  SomePath path;
  Errors errors;
  const auto add = [&](int k) {
    system.put(k * period / steps);
    spoil(system);
    path.add_node(system, k * period / steps);
  };
  add(0);
  for (int k = 1; k <= steps; ++k) {
    add(k);
    for (int tenth = 1; tenth < 10 && k >= 3; ++tenth) {
      const double time = (k - 1 + 0.1 * tenth) * period / steps;
      path.go_to(system, time);
      errors.position = std::max(errors.position, system.position_error(time));
      errors.velocity = std::max(errors.velocity, system.velocity_error(time));
    }
  }
  return errors;
}

/// Whether positions have order degree + 1 and velocities `degree`, to 0.2.
template <class SomePath, class Spoil>
testing::AssertionResult has_degree(int degree, Spoil spoil) {
  constexpr int coarse = 10, fine = 16;
  const Errors before = errors_on_circle<SomePath>(coarse, spoil);
  const Errors after = errors_on_circle<SomePath>(fine, spoil);
  const double refined = std::log(1.0 * fine / coarse);
  const double position = std::log(before.position / after.position) / refined;
  const double velocity = std::log(before.velocity / after.velocity) / refined;
  if (std::abs(position - (degree + 1)) <= 0.2 && std::abs(velocity - degree) <= 0.2)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "orders " << position << ", " << velocity;
}

constexpr auto exactly = [](KeplerProblem&) {};

template <class SomePath>
struct HermitePaths : testing::Test {};
TYPED_TEST_SUITE(HermitePaths, TypesOf<Paths>::type, NameOfType);

TYPED_TEST(HermitePaths, HaveTheirDegree) {
  EXPECT_TRUE(has_degree<TypeParam>(TypeParam::degree, exactly));
  EXPECT_FALSE(has_degree<TypeParam>(TypeParam::degree - 1, exactly));
  EXPECT_FALSE(has_degree<TypeParam>(TypeParam::degree + 1, exactly));
}

TYPED_TEST(HermitePaths, LoseItWithWrongTangents) {
  EXPECT_FALSE(has_degree<TypeParam>(TypeParam::degree, [](KeplerProblem& system) {
    auto state = system.state();
    for (const std::size_t d : {2, 3}) state[d] *= 1 + 1e-3;
    system.put(state);
  }));
}

/// Nodes on an ellipse, at times that are not equally spaced.
constexpr double node_time(int k) { return 0.2 * k + 0.01 * k * k; }
void add_nodes(Path& path, KeplerProblem& system, int from, int to) {
  for (int k = from; k < to; ++k) {
    system.put(node_time(k));
    path.add_node(system, node_time(k));
  }
}

std::vector<double> gone_to(const Path& path, double time) {
  KeplerProblem system(0.3);
  path.go_to(system, time);
  return system.state();
}

TYPED_TEST(HermitePaths, AreTheNodeAtANode) {
  KeplerProblem system(0.3);
  TypeParam path;
  add_nodes(path, system, 0, 5);
  EXPECT_EQ(gone_to(path, node_time(4)), system.state());
  system.put(node_time(3));
  EXPECT_EQ(gone_to(path, node_time(3)), system.state());
}

TYPED_TEST(HermitePaths, GoOnAfterARestartWithTheSameBits) {
  KeplerProblem system(0.3);
  TypeParam path, other;
  add_nodes(path, system, 0, 5);
  other.recall(path.memory());
  add_nodes(path, system, 5, 6);
  add_nodes(other, system, 4, 6);  // a restart adds the node that it starts from
  EXPECT_EQ(gone_to(other, 1.15), gone_to(path, 1.15));
  EXPECT_EQ(other.memory(), path.memory());
}

TYPED_TEST(HermitePaths, RefuseTheMemoryOfAnother) {
  KeplerProblem system(0.3);
  TypeParam path;
  add_nodes(path, system, 0, 5);
  std::vector<double> memory = path.memory();
  memory.pop_back();
  EXPECT_THROW(path.recall(memory), InputError);
}

template <class SomePath>
std::vector<double> in_step(int nodes, double time) {
  KeplerProblem system(0.3);
  SomePath path;
  add_nodes(path, system, 0, nodes);
  return gone_to(path, time);
}

TEST(HermitePath, BeginsWithTheNodesThatThereAre) {
  EXPECT_EQ(in_step<ThreeStepHermite>(2, 0.1), in_step<QuinticHermite>(2, 0.1));
  EXPECT_EQ(in_step<ThreeStepHermite>(3, 0.3), in_step<TwoStepHermite>(3, 0.3));
  EXPECT_NE(in_step<ThreeStepHermite>(4, 0.6), in_step<TwoStepHermite>(4, 0.6));
}

TEST(HermitePath, WantsAccelerationsOnlyWhereItUsesThem) {
  KeplerProblem system(0.3);
  CubicHermite cubic;
  QuinticHermite quintic;
  add_nodes(cubic, system, 0, 3);
  EXPECT_EQ(system.evaluations, 0);
  add_nodes(quintic, system, 0, 3);
  EXPECT_EQ(system.evaluations, 3);
}

TEST(HermitePath, RemembersNothingBeforeTheFirstNode) {
  QuinticHermite path;
  path.recall(path.memory());
  KeplerProblem system(0.3);
  add_nodes(path, system, 0, 2);
  EXPECT_EQ(gone_to(path, node_time(1)), system.state());
}

}  // namespace
}  // namespace mote::test
