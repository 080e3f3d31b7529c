#include "mote/operators/differential/vortex_blob.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel_cases.hpp"
#include "mote/operators/differential/sph.hpp"
#include "paper_sums.hpp"
#include "support/altered_operator.hpp"
#include "support/derivatives.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double tolerance = 1e-12;

template <class Case>
struct VortexBlob : testing::Test {
  static constexpr int D = Case::dimension;
  using Kernel = typename Case::Kernel;
  using Operator = mote::VortexBlob<D, Kernel>;

  Points<D> points = jittered_cloud<D>({.side = usual_side<D>});
  std::vector<double> scalar = Draws(3).uniform(points.length.size(), -1, 1);
  std::vector<double> vector = Draws(4).uniform(points.position.size(), -1, 1);

  void SetUp() override { give_circulation(points, 9); }

  template <class Family = Operator>
  static Family make_operator(DensityFrom source = DensityFrom::points) {
    Family op;
    op.smoothing_length = 2.6 / op.kernel.support();
    op.density_from = source;
    return op;
  }

  /// Section 2 with omega and Omega in place of rho and M; the sum (44) where it is asked for.
  WideDerivatives expected(const Operator& op) const {
    const NeighbourRule rule = op.neighbour_rule();
    const Smoothed smoothed{widened(points.circulation),
                            op.density_from == DensityFrom::points
                                ? widened(points.vorticity)
                                : summed_density(points, rule, op.kernel, points.circulation)};
    return paper_sums<D>(points, rule, scalar, vector,
                         [&](const Row<D>& row, WideDerivatives& result) {
                           add_sph_row(op.kernel, row, smoothed, result);
                         });
  }
};
TYPED_TEST_SUITE(VortexBlob, OperatorKernelCases, KernelCaseName);

TYPED_TEST(VortexBlob, EqualsThePrintedSumsWithAVorticityOfBothSigns) {
  auto op = TestFixture::make_operator();
  EXPECT_TRUE(all_agree<TestFixture::D>(
      derivatives_of(op, this->points, this->scalar, this->vector), this->expected(op), tolerance));
}

// Circulations of one sign: the sum of both signs comes near 0 somewhere, and loses digits there.
TYPED_TEST(VortexBlob, EqualsThePrintedSumsWithTheVorticitySummedUp) {
  for (double& circulation : this->points.circulation) circulation = -0.5 - std::abs(circulation);
  auto op = TestFixture::make_operator(DensityFrom::summation);
  EXPECT_TRUE(all_agree<TestFixture::D>(
      derivatives_of(op, this->points, this->scalar, this->vector), this->expected(op), tolerance));
}

TYPED_TEST(VortexBlob, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  const auto op = TestFixture::make_operator();
  AlteredOperator<D, typename TestFixture::Operator> altered(op, 7, 1e-3);
  EXPECT_FALSE(all_agree<D>(derivatives_of(altered, this->points, this->scalar, this->vector),
                            this->expected(op), tolerance));
}

TYPED_TEST(VortexBlob, HasTheBitsOfSphWhereCirculationIsMassAndVorticityDensity) {
  constexpr int D = TestFixture::D;
  using Sph = mote::Sph<D, typename TestFixture::Kernel>;
  this->points.circulation = this->points.mass;
  this->points.vorticity = this->points.density;
  for (const DensityFrom source : {DensityFrom::points, DensityFrom::summation}) {
    auto blob = TestFixture::make_operator(source);
    auto sph = TestFixture::template make_operator<Sph>(source);
    const auto of_sph = derivatives_of<D>(sph, this->points, this->scalar, this->vector);
    EXPECT_TRUE(
        all_agree<D>(derivatives_of(blob, this->points, this->scalar, this->vector), of_sph, 0));
  }
}

TYPED_TEST(VortexBlob, DiffersFromSphOtherwise) {
  constexpr int D = TestFixture::D;
  auto blob = TestFixture::make_operator();
  auto sph = TestFixture::template make_operator<mote::Sph<D, typename TestFixture::Kernel>>();
  const auto of_sph = derivatives_of<D>(sph, this->points, this->scalar, this->vector);
  EXPECT_TRUE(
      none_agrees<D>(derivatives_of(blob, this->points, this->scalar, this->vector), of_sph, 0.1));
}

using Blob = mote::VortexBlob<2, CubicSpline<2>>;

struct VortexBlobRefusal : testing::Test {
  Points<2> points = jittered_cloud<2>({.side = 6});
  Blob op;
  void SetUp() override {
    give_circulation(points, 9);
    op.smoothing_length = 2.6;
  }
  void prepare() { op.prepare(points, brute_force(points, op.neighbour_rule())); }

  void expect_refusal_of(Index particle, const std::string& reason) {
    try {
      prepare();
      FAIL() << "the operator accepts these points";
    } catch (const NumericalFailure& failure) {
      EXPECT_THAT(failure.particles(), ElementsAre(particle));
      EXPECT_THAT(failure.what(),
                  HasSubstr("the vorticity of particle " + std::to_string(particle) + reason));
      EXPECT_THAT(failure.cause(), HasSubstr("divides by it"));
    }
  }
};

TEST_F(VortexBlobRefusal, NamesTheFirstParticleWithoutVorticity) {
  points.vorticity[5] = points.vorticity[3] = 0;
  expect_refusal_of(3, " is 0");
}

TEST_F(VortexBlobRefusal, NamesAParticleWhoseVorticityIsNotFinite) {
  points.vorticity[4] = std::nan("");
  expect_refusal_of(4, " is not finite");
}

TEST_F(VortexBlobRefusal, NamesAParticleWhoseSummedVorticityIsZero) {
  std::ranges::fill(points.circulation, 0);
  op.density_from = DensityFrom::summation;
  expect_refusal_of(0, " is 0");
}

TEST_F(VortexBlobRefusal, DoesNotCountPointsThatAreNoReceivers) {
  points.vorticity.back() = 0;
  EXPECT_NO_THROW(prepare());
}

TEST_F(VortexBlobRefusal, IsABadInputWherePointsHaveNoCirculation) {
  points.circulation.clear();
  points.vorticity.clear();
  try {
    prepare();
    FAIL() << "the operator accepts these points";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "operator");
    EXPECT_THAT(error.what(), HasSubstr("vortex_blob needs points with circulation"));
  }
}

}  // namespace
}  // namespace mote::test
