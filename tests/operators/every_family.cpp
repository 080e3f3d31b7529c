// What holds for every family of operators: the Hessian is symmetric with the Laplacian as its
// trace, and the bits are those of one thread.

#include <gtest/gtest.h>
#include <omp.h>

#include "mote/neighbours/kd_tree.hpp"
#include "mote/neighbours/line.hpp"
#include "mote/operators/differential/all.hpp"
#include "mote/operators/kernels/all.hpp"
#include "support/altered_operator.hpp"
#include "support/derivatives.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

/// A family in D dimensions, those with a kernel on the cubic spline, with a reach of a few points.
template <class Family, int Dimension>
struct FamilyCase {
  using Operator = Family;
  static constexpr int D = Dimension;

  static Operator make_operator() {
    Operator op;
    if constexpr (requires { op.kernel; }) op.smoothing_length = 3.6;
    return op;
  }
};

template <class List, int D>
struct CasesOfFamilies;
template <template <int, class> class... Family, int D>
struct CasesOfFamilies<KernelFamilyList<Family...>, D> {
  using type = testing::Types<FamilyCase<Family<D, CubicSpline<D>>, D>...>;
};
template <template <int> class... Family, int D>
struct CasesOfFamilies<FamilyList<Family...>, D> {
  using type = testing::Types<FamilyCase<Family<D>, D>...>;
};

struct FamilyName {
  template <class Case>
  static std::string GetName(int number) {
    return std::string(Case::Operator::family) + "_" + std::to_string(number);
  }
};

NeighbourLists search(const Points<1>& points, const NeighbourRule& rule) {
  NeighbourLists lists;
  LineSearch().find(points, rule, lists);
  return lists;
}
template <int D>
NeighbourLists search(const Points<D>& points, const NeighbourRule& rule) {
  NeighbourLists lists;
  KdTreeSearch<D>().find(points, rule, lists);
  return lists;
}

/// A lattice, which every family takes: its inner points are the receivers.
template <int D>
Points<D> inner_lattice(Index side, Index margin) {
  auto points = jittered_cloud<D>({.side = side, .jitter = 0, .variation = 0});
  points.receivers = 0;
  for (Index i = 0; i < points.size(); ++i) {
    if (points.at(i).minCoeff() < margin || points.at(i).maxCoeff() > side - 1 - margin) continue;
    for (int d = 0; d < D; ++d)
      std::swap(points.position[i * D + d], points.position[points.receivers * D + d]);
    ++points.receivers;
  }
  Draws draws(8);
  for (auto* values : {&points.mass, &points.density})
    for (double& value : *values) value = draws.uniform(0.8, 1.2);
  give_circulation(points, 9);
  return points;
}

/// Whether every H_ij of `op` is symmetric with the l_ij of `other` as its trace, to within
/// rounding of the largest weight.
template <int D>
testing::AssertionResult has_as_trace(DifferentialOperator<D>& op, DifferentialOperator<D>& other) {
  const auto points = inner_lattice<D>(D == 1 ? 40 : (D == 2 ? 12 : 7), 1);
  const NeighbourLists lists = search(points, op.neighbour_rule());
  std::vector<double> traces, laplacian, entries, transposed;
  op.prepare(points, lists);
  other.prepare(points, lists);
  for (Index i = 0; i < points.receivers; ++i) {
    std::vector<Mat<D>> matrices(lists[i].size());
    std::vector<double> row(lists[i].size());
    op.hessian_weights(i, matrices);
    other.laplacian_weights(i, row);
    laplacian.insert(laplacian.end(), row.begin(), row.end());
    for (const Mat<D>& matrix : matrices) {
      const Mat<D> other_way = matrix.transpose();
      traces.push_back(matrix.trace());
      entries.insert(entries.end(), matrix.data(), matrix.data() + D * D);
      transposed.insert(transposed.end(), other_way.data(), other_way.data() + D * D);
    }
  }
  if (const auto symmetric = agree(entries, transposed, 1e-15); !symmetric) return symmetric;
  return agree(traces, laplacian, 1e-10);
}

/// The derivatives of random fields with this many threads.
template <int D>
Derivatives derivatives_with(int threads, DifferentialOperator<D>& op, const Points<D>& points) {
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(threads);
  const auto scalar = Draws(3).uniform(points.length.size(), -1, 1);
  const auto vector = Draws(4).uniform(points.position.size(), -1, 1);
  const auto result =
      derivatives_of(op, points, search(points, op.neighbour_rule()), scalar, vector);
  omp_set_num_threads(threads_before);
  return result;
}

template <int D>
void expect_the_same_bits(DifferentialOperator<D>& op) {
  const auto points = inner_lattice<D>(D == 1 ? 4100 : (D == 2 ? 68 : 19), D == 1 ? 40 : 1);
  ASSERT_GE(points.receivers, parallel_from);
  const Derivatives one = derivatives_with<D>(1, op, points);
  for (const int threads : {2, 4}) {
    const Derivatives several = derivatives_with<D>(threads, op, points);
    EXPECT_TRUE(one.gradient == several.gradient) << threads;
    EXPECT_TRUE(one.divergence == several.divergence) << threads;
    EXPECT_TRUE(one.laplacian == several.laplacian) << threads;
    EXPECT_TRUE(one.curl == several.curl) << threads;
    EXPECT_TRUE(one.hessian == several.hessian) << threads;
  }
}

template <class Case>
struct EveryFamily : testing::Test {
  typename Case::Operator op = Case::make_operator();
};
TYPED_TEST_SUITE_P(EveryFamily);

TYPED_TEST_P(EveryFamily, HasASymmetricHessianWithTheLaplacianAsTrace) {
  EXPECT_TRUE(this->op.has_hessian());
  EXPECT_TRUE(has_as_trace<TypeParam::D>(this->op, this->op));
}

TYPED_TEST_P(EveryFamily, CheckNoticesALaplacianOfWhichOneWeightIsAltered) {
  AlteredOperator<TypeParam::D, typename TypeParam::Operator> altered(this->op, 7, 1e-6);
  EXPECT_FALSE(has_as_trace<TypeParam::D>(this->op, altered));
}

TYPED_TEST_P(EveryFamily, HasTheSameBitsForAnyNumberOfThreads) {
  expect_the_same_bits<TypeParam::D>(this->op);
}

REGISTER_TYPED_TEST_SUITE_P(EveryFamily, HasASymmetricHessianWithTheLaplacianAsTrace,
                            CheckNoticesALaplacianOfWhichOneWeightIsAltered,
                            HasTheSameBitsForAnyNumberOfThreads);

template <class List, int D>
using Cases = typename CasesOfFamilies<List, D>::type;
using KernelFamilies1 = Cases<KernelFamilies, 1>;
using KernelFamilies2 = Cases<KernelFamilies, 2>;
using KernelFamilies3 = Cases<KernelFamilies, 3>;
using PlainFamilies1 = Cases<PlainFamilies, 1>;
using PlainFamilies2 = Cases<PlainFamilies, 2>;
using PlainFamilies3 = Cases<PlainFamilies, 3>;
INSTANTIATE_TYPED_TEST_SUITE_P(OnAKernel1d, EveryFamily, KernelFamilies1, FamilyName);
INSTANTIATE_TYPED_TEST_SUITE_P(OnAKernel2d, EveryFamily, KernelFamilies2, FamilyName);
INSTANTIATE_TYPED_TEST_SUITE_P(OnAKernel3d, EveryFamily, KernelFamilies3, FamilyName);
INSTANTIATE_TYPED_TEST_SUITE_P(Plain1d, EveryFamily, PlainFamilies1, FamilyName);
INSTANTIATE_TYPED_TEST_SUITE_P(Plain2d, EveryFamily, PlainFamilies2, FamilyName);
INSTANTIATE_TYPED_TEST_SUITE_P(Plain3d, EveryFamily, PlainFamilies3, FamilyName);

}  // namespace
}  // namespace mote::test
