// Neighbourhoods that do not fix the derivatives: which operators refuse them, and what they say.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bad_groups.hpp"
#include "mote/operators/differential/corrected_sph.hpp"
#include "mote/operators/differential/least_squares.hpp"
#include "mote/operators/kernels/wendland_c2.hpp"
#include "support/polynomial.hpp"

namespace mote::test {
namespace {

/// An operator that finds its weights by solving for them, in one dimension; `dense` is a distance
/// at which a line of points has enough neighbours for it.
template <int Dimension>
struct Corrected {
  static constexpr int D = Dimension, degree = 2;
  static constexpr const char* too_few = "too few";
  static constexpr const char* degenerate = "too few directions";
  using Operator = CorrectedSph<D, WendlandC2<D>>;
  static std::string name() { return "corrected_sph_" + std::to_string(D) + "d"; }
};

template <int Dimension, int Degree>
struct Fitted {
  static constexpr int D = Dimension, degree = Degree;
  static constexpr const char* too_few = "too few: a larger smoothing_length";
  static constexpr const char* degenerate = "too few lines";
  using Operator = LeastSquares<D, degree>;
  static std::string name() {
    return "least_squares_" + std::to_string(degree) + "_" + std::to_string(D) + "d";
  }
};

template <class Case>
struct Refusal : testing::Test {
  static constexpr int D = Case::D;
  static constexpr Index side = D == 1 ? 20 : (D == 2 ? 10 : 7);

  static typename Case::Operator make_operator() {
    typename Case::Operator op;
    op.smoothing_length = (Case::degree + 1.5) / op.neighbour_rule().support;
    return op;
  }

  static void expect(const Places<D>& group, const std::string& what, const std::string& cause) {
    expect_refusal<D>(make_operator(), cloud_with_group<D>(side, group), first_of_group, what,
                      cause);
  }
};
struct CaseName {
  template <class Case>
  static std::string GetName(int) {
    return Case::name();
  }
};
using Cases = testing::Types<Corrected<1>, Corrected<2>, Corrected<3>, Fitted<1, 2>, Fitted<1, 3>,
                             Fitted<1, 4>, Fitted<2, 2>, Fitted<2, 3>, Fitted<2, 4>, Fitted<3, 2>,
                             Fitted<3, 3>, Fitted<3, 4>>;
TYPED_TEST_SUITE(Refusal, Cases, CaseName);

template <class Case>
using RefusalOffALine = Refusal<Case>;
using CasesOffALine = testing::Types<Corrected<2>, Corrected<3>, Fitted<2, 2>, Fitted<2, 3>,
                                     Fitted<2, 4>, Fitted<3, 2>, Fitted<3, 3>, Fitted<3, 4>>;
TYPED_TEST_SUITE(RefusalOffALine, CasesOffALine, CaseName);

template <class Case>
using RefusalInSpace = Refusal<Case>;
using CasesInSpace = testing::Types<Corrected<3>, Fitted<3, 2>, Fitted<3, 3>, Fitted<3, 4>>;
TYPED_TEST_SUITE(RefusalInSpace, CasesInSpace, CaseName);

TYPED_TEST(Refusal, NamesTheFirstParticleWithTooFewNeighbours) {
  TestFixture::expect(places_on_a_line<TestFixture::D>(2, 1), "1 neighbours", TypeParam::too_few);
}

TYPED_TEST(Refusal, NamesTheFirstParticleWithoutNeighbours) {
  TestFixture::expect(places_on_a_line<TestFixture::D>(1, 1), "0 neighbours", TypeParam::too_few);
}

TYPED_TEST(Refusal, NamesTheFirstOfCoincidentParticles) {
  TestFixture::expect(places_on_a_line<TestFixture::D>(50, 0), "49 neighbours", "same place");
}

// Enough for a gradient, and for no second derivative.
TYPED_TEST(Refusal, NamesTheFirstParticleOfASimplex) {
  constexpr int D = TestFixture::D;
  TestFixture::expect(places_of_a_simplex<D>(), std::to_string(D) + " neighbours",
                      TypeParam::too_few);
}

TYPED_TEST(RefusalOffALine, NamesTheFirstOfCollinearParticles) {
  TestFixture::expect(places_on_a_line<TestFixture::D>(60, 0.05), "neighbours",
                      TypeParam::degenerate);
}

TYPED_TEST(RefusalInSpace, NamesTheFirstOfCoplanarParticles) {
  TestFixture::expect(places_on_a_plane(15, 0.5), "neighbours", TypeParam::degenerate);
}

TYPED_TEST(Refusal, AcceptsTheCloudWithoutTheGroup) {
  constexpr int D = TestFixture::D;
  const auto points = cloud_with_group<D>(TestFixture::side, {});
  auto op = TestFixture::make_operator();
  EXPECT_NO_THROW(op.prepare(points, brute_force(points, op.neighbour_rule())));
}

/// A group whose points have eight neighbours each: too few for the nine unknowns of a cubic, and
/// enough for the five of a parabola.
Points<2> cloud_with_nine() {
  Places<2> group;
  for (int k = 0; k < 9; ++k) group.emplace_back(k % 3 + 0.1 * (k % 2), k / 3 + 0.1 * (k % 5));
  return cloud_with_group<2>(10, group);
}

LeastSquares<2, 4> lowering_operator() {
  LeastSquares<2, 4> op;
  op.smoothing_length = 5.5;
  op.lower_degree = true;
  return op;
}

TEST(LowerDegree, IsTakenWhereNeighboursAreTooFewAndSaidInARemark) {
  auto op = lowering_operator();
  const auto points = cloud_with_nine();
  EXPECT_TRUE(is_exact<2>(op, points, 2, 1e-9));
  EXPECT_THAT(op.remarks(),
              testing::ElementsAre("9 points have neighbours that do not fix degree 4, "
                                   "the first of them point 3; a lower degree was "
                                   "used there"));
}

TEST(LowerDegree, IsExactForAParabolaThereAndForNothingMore) {
  auto op = lowering_operator();
  EXPECT_TRUE(is_nowhere_exact<2>(op, cloud_with_nine(), 3, 1e-4));
  EXPECT_TRUE(is_exact<2>(op, cloud_with_group<2>(10, {}), 4, 1e-9));
  EXPECT_THAT(op.remarks(), testing::IsEmpty());
}

TEST(LowerDegree, IsNotTakenUnasked) {
  auto op = lowering_operator();
  op.lower_degree = false;
  expect_refusal<2>(op, cloud_with_nine(), first_of_group, "8 neighbours", "lower_degree");
}

TEST(LowerDegree, IsNeverBelowTwo) {
  expect_refusal<2>(lowering_operator(), cloud_with_group<2>(10, places_on_a_line<2>(9, 1)),
                    first_of_group, "neighbours", "");
}

}  // namespace
}  // namespace mote::test
