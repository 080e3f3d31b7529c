#include "mote/operators/differential/morris.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mote/operators/kernels/wendland_c2.hpp"
#include "mote/particles/failure.hpp"
#include "paper_sums.hpp"
#include "support/agreement.hpp"
#include "support/altered_operator.hpp"
#include "support/derivatives.hpp"
#include "support/dimensions.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

/// The sums of the docstring of Morris at every receiver, in long double.
template <int D>
class LiteralMorris {
 public:
  using Operator = Morris<D, WendlandC2<D>>;

  LiteralMorris(const Points<D>& points, const Operator& op) : points_(points), op_(op) {}

  void add(const Row<D>& row, WideDerivatives& result) const {
    long double second_moment = 0, laplacian = 0, divergence = 0;
    WideVector<D> gradient{};
    std::array<long double, 3> curl{};
    std::array<std::array<long double, D>, D> hessian{};
    for (std::size_t j = 0; j < row.r.size(); ++j) {
      if (static_cast<Index>(j) == row.i) continue;
      const long double f = slope(row, j), r2 = row.r[j] * row.r[j];
      second_moment += f * r2;
      laplacian -= 2 * f * row.difference[j];
      divergence += f * dot(row.x[j], row.a[j]);
      add_cross(f, row.x[j], row.a[j], curl);
      for (int c = 0; c < D; ++c) {
        gradient[c] += f * row.x[j][c] * row.difference[j];
        for (int d = 0; d < D; ++d)
          hessian[c][d] -=
              f * row.difference[j] * ((D + 2) * row.x[j][c] * row.x[j][d] / r2 - (c == d));
      }
    }
    const long double scale = D / second_moment;
    for (long double& component : curl) component *= scale;
    append_curl<D>(curl, result);
    for (const long double component : gradient) result.gradient.push_back(scale * component);
    result.divergence.push_back(scale * divergence);
    result.laplacian.push_back(scale * laplacian);
    for (const auto& line : hessian)
      for (const long double entry : line) result.hessian.push_back(scale * entry);
  }

 private:
  long double slope(const Row<D>& row, std::size_t j) const {
    const auto q = static_cast<double>(row.r[j] / row.h[j]);
    const long double volume = static_cast<long double>(points_.mass[j]) / points_.density[j];
    return -volume * op_.kernel.slope_over_q(q) / std::pow(row.h[j], D + 2);
  }

  const Points<D>& points_;
  const Operator& op_;
};

template <class Dimension>
struct MorrisOperator : testing::Test {
  static constexpr int D = Dimension::value;
  using Operator = Morris<D, WendlandC2<D>>;

  Points<D> points = jittered_cloud<D>({.side = usual_side<D>});
  std::vector<double> scalar = Draws(3).uniform(points.length.size(), -1, 1);
  std::vector<double> vector = Draws(4).uniform(points.position.size(), -1, 1);

  static Operator make_operator(PairLength length = PairLength::mean) {
    Operator op;
    op.smoothing_length = 2.6;
    op.length = length;
    return op;
  }

  WideDerivatives expected(const Operator& op) const {
    const LiteralMorris<D> literal(points, op);
    return paper_sums<D>(
        points, op.neighbour_rule(), scalar, vector,
        [&](const Row<D>& row, WideDerivatives& result) { literal.add(row, result); });
  }
};
TYPED_TEST_SUITE(MorrisOperator, Dimensions, NameOfDimension);

TYPED_TEST(MorrisOperator, EqualsItsSumsForEveryPairLength) {
  for (const PairLength length : {PairLength::mean, PairLength::scatter, PairLength::gather}) {
    auto op = TestFixture::make_operator(length);
    const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
    EXPECT_TRUE(all_agree<TestFixture::D>(found, this->expected(op), 1e-12));
  }
}

TYPED_TEST(MorrisOperator, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  const auto op = TestFixture::make_operator();
  AlteredOperator<D, typename TestFixture::Operator> altered(op, 7, 1e-4);
  const auto found = derivatives_of(altered, this->points, this->scalar, this->vector);
  EXPECT_TRUE(none_agrees<D>(found, this->expected(op), 1e-12));
}

/// The Laplacian of r^2 about each receiver, and that of x.
TYPED_TEST(MorrisOperator, HasTheLaplacianOfASphereButNotThatOfAPlaneOnIrregularPoints) {
  constexpr int D = TestFixture::D;
  auto op = TestFixture::make_operator();
  const NeighbourLists lists = brute_force(this->points, op.neighbour_rule());
  op.prepare(this->points, lists);
  double off_plane = 0;
  for (Index i = 0; i < this->points.receivers; ++i) {
    std::vector<double> weights(lists[i].size());
    op.laplacian_weights(i, weights);
    double sphere = 0, plane = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const Vec<D> x = this->points.at(lists[i][k]) - this->points.at(i);
      sphere += weights[k] * x.squaredNorm();
      plane += weights[k] * x[0];
    }
    EXPECT_NEAR(sphere, 2 * D, 1e-12);
    off_plane = std::max(off_plane, std::abs(plane));
  }
  EXPECT_GT(off_plane, 1e-2);
}

TEST(MorrisOperator, RefusesAParticleWithoutNeighboursByName) {
  auto points = jittered_cloud<2>({.side = 5, .jitter = 0.05, .variation = 0});
  points.position[4] = 1000;
  Morris<2, WendlandC2<2>> op;
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  try {
    op.prepare(points, lists);
    ADD_FAILURE() << "the operator accepts these points";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.particles(), testing::ElementsAre(2));
    EXPECT_THAT(failure.what(), testing::HasSubstr("particle 2 has 0 neighbours"));
  }
}

}  // namespace
}  // namespace mote::test
