#include <gtest/gtest.h>

#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/expint.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "core_checks.hpp"
#include "mote/operators/cores/all.hpp"
#include "support/typed_lists.hpp"

namespace mote::test {
namespace {

template <class C>
struct Core : testing::Test {
  static_assert(VortexCore<C>);

  /// Calls check.template operator()<D>() in 2 and 3 dimensions.
  template <class Check>
  static void expect(Check check) {
    EXPECT_TRUE(check.template operator()<2>()) << "in 2D";
    EXPECT_TRUE(check.template operator()<3>()) << "in 3D";
  }
};
TYPED_TEST_SUITE(Core, TypesOf<VortexCores>::type, NameOfType);

TYPED_TEST(Core, HasTotalCirculationOne) {
  TestFixture::expect([]<int D>() { return near(moment<D, TypeParam>(0), 1, 1e-12); });
  TestFixture::expect([]<int D>() { return near(within<D, TypeParam>(1e6), 1, 1e-11); });
}
TYPED_TEST(Core, HasTheMomentsOfItsOrder) {
  for (int power = 2; power < TypeParam::order; power += 2)
    TestFixture::expect([&]<int D>() { return near(moment<D, TypeParam>(power), 0, 1e-12); });
  TestFixture::expect([]<int D>() {
    return testing::AssertionResult(std::abs(moment<D, TypeParam>(TypeParam::order)) > 0.1);
  });
}
TYPED_TEST(Core, BlobIsTheSlopeOfItsCirculation) {
  TestFixture::expect([]<int D>() { return blob_is_slope_of_circulation<D, TypeParam>(); });
}
TYPED_TEST(Core, InfluenceSlopeIsTheDerivative) {
  TestFixture::expect([]<int D>() { return influence_slope_is_derivative<D, TypeParam>(); });
}
TYPED_TEST(Core, PotentialHasTheSlopeOfTheInfluence) {
  TestFixture::expect([]<int D>() { return potential_has_the_slope_of_influence<D, TypeParam>(); });
}
TYPED_TEST(Core, PotentialIsAPointsFarAway) {
  TestFixture::expect([]<int D>() { return potential_is_a_points_far_away<D, TypeParam>(); });
}
TYPED_TEST(Core, ReachIsWhereItBecomesAPoint) {
  TestFixture::expect([]<int D>() { return reach_is_right<D, TypeParam>(); });
}
TYPED_TEST(Core, LanesEqualNumbers) {
  TestFixture::expect([]<int D>() { return lanes_equal_numbers<D, TypeParam>(); });
}

/// A Gaussian of which one thing is wrong by a little.
enum class Wrong { nothing, influence, influence_slope, blob, potential, reach };
template <Wrong wrong>
struct Tampered {
  static constexpr double factor(Wrong of) { return of == wrong ? 1 + 1e-7 : 1; }
  template <int D, class Real>
  static Real influence(const Real& t) {
    return factor(Wrong::influence) * GaussCore::influence<D>(t);
  }
  template <int D, class Real>
  static Real influence_slope(const Real& t) {
    return factor(Wrong::influence_slope) * GaussCore::influence_slope<D>(t);
  }
  template <int D, class Real>
  static Real blob(const Real& t) {
    return factor(Wrong::blob) * GaussCore::blob<D>(t);
  }
  template <int D, class Real>
  static Real potential(const Real& t) {
    return factor(Wrong::potential) * GaussCore::potential<D>(t);
  }
  template <int D>
  static double reach(double tolerance) {
    return (wrong == Wrong::reach ? 0.9 : 1) * GaussCore::reach<D>(tolerance);
  }
};

template <Wrong wrong, int D>
void expect_noticed() {
  using Core = Tampered<wrong>;
  const auto amiss = [](auto... parts) { return ((parts == wrong) || ...); };
  EXPECT_EQ(!near(moment<D, Core>(0), 1, 1e-12), amiss(Wrong::blob));
  EXPECT_EQ(!near(within<D, Core>(1e6), 1, 1e-11), amiss(Wrong::influence));
  EXPECT_EQ(!(blob_is_slope_of_circulation<D, Core>()), amiss(Wrong::blob, Wrong::influence));
  EXPECT_EQ(!(influence_slope_is_derivative<D, Core>()),
            amiss(Wrong::influence, Wrong::influence_slope));
  EXPECT_EQ(!(potential_has_the_slope_of_influence<D, Core>()),
            amiss(Wrong::influence, Wrong::potential));
  EXPECT_EQ(!(potential_is_a_points_far_away<D, Core>()), amiss(Wrong::potential));
  EXPECT_EQ(!(reach_is_right<D, Core>()), amiss(Wrong::reach, Wrong::influence, Wrong::blob));
}
template <Wrong... wrong>
void expect_all_noticed() {
  (expect_noticed<wrong, 2>(), ...);
  (expect_noticed<wrong, 3>(), ...);
}
TEST(CoreChecks, NoticeWhatIsWrongAndNothingElse) {
  expect_all_noticed<Wrong::nothing, Wrong::influence, Wrong::influence_slope, Wrong::blob,
                     Wrong::potential, Wrong::reach>();
}

/// Whether f equals the reference to a relative 1e-15 wherever q changes, and near 0.
template <class Function, class Reference>
testing::AssertionResult equal(Function f, Reference reference) {
  for (double t = 1e-12; t < 1e3; t *= 1.01) {
    const long double expected = reference(static_cast<long double>(t));
    if (const long double error = std::abs(f(t) / expected - 1); !(error <= 1e-15L))
      return testing::AssertionFailure() << "relative error " << error << " at rho^2 = " << t;
  }
  return testing::AssertionSuccess();
}

using Long = long double;

TEST(GaussCore, InfluenceIsTheIncompleteGammaFunction) {
  using boost::math::gamma_p;
  EXPECT_TRUE(equal([](double t) { return GaussCore::influence<2>(t); },
                    [](Long t) { return gamma_p(1.0L, t / 2) / t; }));
  EXPECT_TRUE(equal([](double t) { return GaussCore::influence<3>(t); },
                    [](Long t) { return gamma_p(1.5L, t / 2) / (t * std::sqrt(t)); }));
}
TEST(GaussCore, InfluenceSlopeIsTheNextIncompleteGammaFunction) {
  using boost::math::tgamma_lower;
  const auto slope = [](Long half_power, Long peak, Long x) {
    return -peak * tgamma_lower(half_power, x) / (2 * std::pow(x, half_power));
  };
  EXPECT_TRUE(equal([](double t) { return GaussCore::influence_slope<2>(t); },
                    [&](Long t) { return slope(2, 1, t / 2); }));
  EXPECT_TRUE(
      equal([](double t) { return GaussCore::influence_slope<3>(t); },
            [&](Long t) { return slope(2.5L, std::sqrt(2 / std::numbers::pi_v<Long>), t / 2); }));
}
TEST(GaussCore, PotentialIsAnExponentialIntegralOrAnErrorFunction) {
  EXPECT_TRUE(equal([](double t) { return GaussCore::potential<2>(t); },
                    [](Long t) { return (std::log(t) + boost::math::expint(1, t / 2)) / 2; }));
  EXPECT_TRUE(equal([](double t) { return GaussCore::potential<3>(t); },
                    [](Long t) { return std::erf(std::sqrt(t / 2)) / std::sqrt(t); }));
}

TEST(AlgebraicCore, HasThePolynomialsIn2D) {
  for (const double t : {0.1, 0.7, 1.0, 3.0, 40.0}) {
    const Long s = 1 / (1 + static_cast<Long>(t));
    const auto expect = [&](Long influence, Long outside) {
      EXPECT_LE(std::abs(t * influence - (1 - outside)), 1e-15L * (1 - outside));
    };
    expect(AlgebraicCore<2>::influence<2>(t), s * s);
    expect(AlgebraicCore<4>::influence<2>(t), (3 * s - 2) * s * s * s);
    expect(AlgebraicCore<6>::influence<2>(t), ((10 * s - 12) * s + 3) * s * s * s * s);
  }
}
TEST(AlgebraicCore, IsThatOfWinckelmansAndLeonardIn3D) {
  EXPECT_TRUE(equal([](double t) { return AlgebraicCore<2>::influence<3>(t); },
                    [](Long t) { return (t + 2.5L) / std::pow(t + 1, 2.5L); }));
}

// What the lanes compute on their own, over their whole ranges.
template <class Function, class Reference>
testing::AssertionResult equal(Function f, Reference reference, double lower, double upper) {
  for (double x = lower; x < upper; x *= 1.003) {
    const Lanes found = f(Lanes(x));
    const Long expected = reference(static_cast<Long>(x));
    if (const Long error = std::abs(found[0] / expected - 1); !(error <= 3e-16L))
      return testing::AssertionFailure() << "relative error " << error << " at " << x;
  }
  return testing::AssertionSuccess();
}

TEST(LaneFunctions, EqualThoseOfTheStandardLibrary) {
  const auto growth = [](const Lanes& x) { return exponential(x); };
  const auto rise = [](const Lanes& x) { return exponential_rise(x); };
  const auto natural = [](const Lanes& x) { return logarithm(x); };
  const auto decay = [](const Lanes& x) { return exponential(-x); };
  EXPECT_TRUE(equal(
      growth, [](Long x) { return std::exp(x); }, 1e-30, 700));
  EXPECT_TRUE(equal(
      decay, [](Long x) { return std::exp(-x); }, 1e-30, 700));
  EXPECT_TRUE(equal(
      rise, [](Long x) { return -std::expm1(-x); }, 1e-300, 700));
  EXPECT_TRUE(equal(
      natural, [](Long x) { return std::log(x); }, 3e-308, 0.99999));
  EXPECT_TRUE(equal(
      natural, [](Long x) { return std::log(x); }, 1.00001, 1e308));
  EXPECT_EQ(Lanes(logarithm(Lanes(1)))[0], 0);
  EXPECT_EQ(Lanes(exponential(Lanes(0)))[0], 1);
}
TEST(LaneFunctions, ChecksNoticeAShiftedPlace) {
  const auto shifted = [](const Lanes& x) { return exponential(x * (1 + 1e-15)); };
  EXPECT_FALSE(equal(
      shifted, [](Long x) { return std::exp(x); }, 1e-30, 700));
}

}  // namespace
}  // namespace mote::test
