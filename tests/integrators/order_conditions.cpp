#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mote/integrators/all.hpp"
#include "mote/integrators/dormand_prince_853_tableau.hpp"

namespace mote::test {
namespace {

using Vector = std::vector<long double>;
using Matrix = std::vector<Vector>;

Vector vector_of(const auto& numbers, std::size_t size) {
  return Vector(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(size));
}

Matrix matrix_of(const auto& rows, std::size_t size) {
  Matrix result;
  for (std::size_t s = 0; s < size; ++s) result.push_back(vector_of(rows[s], size));
  return result;
}

long double dot(const Vector& a, const Vector& b) {
  long double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// A product of derivatives that turns up in the series of a right-hand side along its solution: a
/// rooted tree (Butcher 1964). It goes with factor * time^power; `stages` is what the method's
/// stages have in its stead.
struct Tree {
  int power;
  long double factor;
  Vector stages;
};

/// Every product of branches whose powers add to `power`.
void grow(const std::vector<Tree>& branches, std::size_t first, int power, const Tree& trunk,
          std::vector<Tree>& trees) {
  if (power == 0) trees.push_back(trunk);
  for (std::size_t k = first; k < branches.size(); ++k) {
    const Tree& branch = branches[k];
    if (branch.power > power) continue;
    Tree longer{trunk.power + branch.power, trunk.factor * branch.factor, trunk.stages};
    for (std::size_t s = 0; s < longer.stages.size(); ++s) longer.stages[s] *= branch.stages[s];
    grow(branches, k, power - branch.power, longer, trees);
  }
}

/// The integral of a tree over time, once or twice, as a branch: by the method's matrix.
Tree branch(const Tree& tree, const Matrix& matrix, int integrals) {
  Tree result{tree.power + integrals, tree.factor, {}};
  for (int k = 1; k <= integrals; ++k) result.factor /= tree.power + k;
  for (const Vector& row : matrix) result.stages.push_back(dot(row, tree.stages));
  return result;
}

/// All trees up to this power that grow from these branches and from integrals of smaller trees.
std::vector<Tree> trees_up_to(int power, const Matrix& matrix, int integrals,
                              std::vector<Tree> branches) {
  std::vector<Tree> trees;
  for (int p = 0; p <= power; ++p) {
    const std::size_t known = trees.size();
    grow(branches, 0, p, {0, 1, Vector(matrix.size(), 1)}, trees);
    for (std::size_t k = known; k < trees.size(); ++k)
      branches.push_back(branch(trees[k], matrix, integrals));
  }
  return trees;
}

/// The trees of x' = f(x).
std::vector<Tree> trees_of_first_order(int power, const Matrix& matrix) {
  return trees_up_to(power, matrix, 1, {});
}

/// The trees of x'' = f(x), where the start velocity is a branch by itself.
std::vector<Tree> trees_of_second_order(int power, const Matrix& matrix, const Vector& node) {
  return trees_up_to(power, matrix, 2, {{1, 1, node}});
}

/// The largest deviation, among trees that this order adds, of what weights make of a tree's stages
/// from its integral, or its integral over an integral.
long double deviation(const std::vector<Tree>& trees, const Vector& weights, int order,
                      int integrals = 1) {
  long double worst = 0;
  for (const Tree& tree : trees) {
    if (tree.power + integrals != order) continue;
    long double exact = tree.factor;
    for (int k = 1; k <= integrals; ++k) exact /= tree.power + k;
    worst = std::max(worst, std::abs(dot(weights, tree.stages) - exact));
  }
  return worst;
}

/// Whether the conditions of every order up to this one hold, and some of the next do not.
testing::AssertionResult is_of_order(int order, const std::vector<Tree>& trees,
                                     const Vector& weights, int integrals = 1) {
  for (int p = integrals; p <= order; ++p)
    if (const auto worst = deviation(trees, weights, p, integrals); worst > 1e-13)
      return testing::AssertionFailure() << "order " << p << " is missed by " << worst;
  if (deviation(trees, weights, order + 1, integrals) > 1e-9) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "it is of order " << order + 1;
}

testing::AssertionResult is_of_order(int order, const auto& tableau) {
  const std::size_t size = tableau.node.size();
  const auto trees = trees_of_first_order(order, matrix_of(tableau.matrix, size));
  return is_of_order(order, trees, vector_of(tableau.weight, size));
}

TEST(OrderConditions, HoldUpToTheOrderOfExplicitMethods) {
  EXPECT_TRUE(is_of_order(2, Heun::tableau));
  EXPECT_TRUE(is_of_order(4, RungeKutta4::tableau));
  EXPECT_TRUE(is_of_order(7, RungeKutta8::tableau));
}

TEST(OrderConditions, AreAsManyAsThereAreTrees) {
  std::vector<int> counts(9);
  for (const Tree& tree : trees_of_first_order(7, matrix_of(Heun::tableau.matrix, 2)))
    ++counts[static_cast<std::size_t>(tree.power) + 1];
  EXPECT_EQ(counts, (std::vector{0, 1, 1, 2, 4, 9, 20, 48, 115}));  // OEIS A000081
}

TEST(OrderConditions, RejectThePrintedEighthOrderMethod) {
  auto printed = RungeKutta8::tableau;
  printed.matrix[7][0] = -234.0 / 20;
  EXPECT_FALSE(is_of_order(7, printed));
  EXPECT_TRUE(is_of_order(3, printed));
}

/// A node of every stage is the sum of its row.
template <std::size_t stages>
void expect_nodes(const auto& node, const auto& matrix, int integrals) {
  for (std::size_t s = 0; s < stages; ++s) {
    double sum = 0;
    for (std::size_t r = 0; r < s; ++r) sum += matrix[s][r];
    EXPECT_NEAR(sum, std::pow(node[s], integrals) / integrals, 2e-14) << s;
  }
}

TEST(OrderConditions, NodesAreTheSumsOfRows) {
  expect_nodes<2>(Heun::tableau.node, Heun::tableau.matrix, 1);
  expect_nodes<4>(RungeKutta4::tableau.node, RungeKutta4::tableau.matrix, 1);
  expect_nodes<10>(RungeKutta8::tableau.node, RungeKutta8::tableau.matrix, 1);
  expect_nodes<16>(dormand_prince_853::node, dormand_prince_853::matrix, 1);
  expect_nodes<9>(RungeKuttaNystrom86::tableau.node, RungeKuttaNystrom86::tableau.matrix, 2);
  expect_nodes<17>(RungeKuttaNystrom1210::tableau.node, RungeKuttaNystrom1210::tableau.matrix, 2);
}

TEST(OrderConditions, HoldForDormandAndPrincesMethods) {
  using namespace dormand_prince_853;
  const auto trees = trees_of_first_order(8, matrix_of(matrix, stages));
  const Vector eighth = vector_of(weight, stages);
  Vector fifth = eighth;
  for (std::size_t s = 0; s < stages; ++s) fifth[s] -= error_5[s];
  EXPECT_TRUE(is_of_order(8, trees, eighth));
  EXPECT_TRUE(is_of_order(5, trees, fifth));
  EXPECT_TRUE(is_of_order(3, trees, vector_of(weight_3, stages)));
}

/// Velocities are one integral of accelerations, places are two.
template <class Method>
void expect_orders(int higher, int lower) {
  const auto& tableau = Method::tableau;
  const std::size_t size = tableau.node.size();
  const auto weights = [size](const auto& numbers) { return vector_of(numbers, size); };
  const auto trees =
      trees_of_second_order(higher, matrix_of(tableau.matrix, size), weights(tableau.node));
  EXPECT_TRUE(is_of_order(higher, trees, weights(tableau.velocity)));
  EXPECT_TRUE(is_of_order(higher, trees, weights(tableau.place), 2));
  EXPECT_TRUE(is_of_order(lower, trees, weights(tableau.lower_velocity)));
  EXPECT_TRUE(is_of_order(lower, trees, weights(tableau.lower_place), 2));
}

TEST(OrderConditions, HoldForTheNystromPairs) {
  expect_orders<RungeKuttaNystrom86>(8, 6);
  expect_orders<RungeKuttaNystrom1210>(12, 10);
}

}  // namespace
}  // namespace mote::test
