#include "mote/operators/differential/mps_as_sph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper_sums.hpp"
#include "support/altered_operator.hpp"
#include "support/derivatives.hpp"
#include "support/quadrature.hpp"
#include "support/settings.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

constexpr double tolerance = 1e-12;
constexpr PairLength pair_lengths[] = {PairLength::mean, PairLength::scatter, PairLength::gather};

/// The weight (54), corrected: eps << r_e, here as a part of r_e. Its alpha makes the integral over
/// space 1, (48) corrected, and goes with r_e^-D.
template <int D>
class PrintedWeight {
 public:
  explicit PrintedWeight(long double part) : part_(part) {
    const auto shell = [&](long double r) {
      return shape(r, 1) * (D == 1 ? 1 : (D == 2 ? r : r * r));
    };
    constexpr long double pi = std::numbers::pi_v<long double>;
    // The weight is steep within a few eps of 0: panels of their own there.
    const long double bend = std::sqrt(part);
    alpha_ = 1 / ((D == 1 ? 2 : 2 * (D - 1) * pi) *
                  (panel_integral(shell, 0, bend) + panel_integral(shell, bend, 1)));
  }

  long double operator()(long double r, long double r_e) const {
    return r <= r_e ? alpha_ / std::pow(r_e, D) * shape(r, r_e) : 0;
  }

 private:
  long double shape(long double r, long double r_e) const {
    const long double eps = part_ * r_e;
    return r_e / (r + eps) - 1 / (1 + eps / r_e);
  }

  long double part_, alpha_;
};

/// (51) to (53), divergence and curl as parts of (51); and (27) with (50) put in.
template <int D>
void add_limit_row(const PrintedWeight<D>& weight, const Points<D>& points, const Row<D>& row,
                   WideDerivatives& result) {
  const long double rho = points.density[row.i];
  WideVector<D> gradient{}, sum{};
  std::array<long double, 3> curl{};
  long double divergence = 0, laplacian = 0;
  std::array<WideVector<D>, D> hessian{};
  for (Index k = 0; k < points.size(); ++k)
    for (int d = 0; d < D && k != row.i; ++d)
      sum[d] += weight(row.r[k], row.h[k]) * row.x[k][d] / (row.r[k] * row.r[k]) * points.mass[k];
  for (Index j = 0; j < points.size(); ++j) {
    if (j == row.i) continue;
    const auto& x = row.x[j];
    const long double r2 = row.r[j] * row.r[j], difference = row.difference[j];
    const long double w = weight(row.r[j], row.h[j]) * points.mass[j];
    divergence += w / r2 * dot(row.a[j], x) / rho;
    add_cross(w / r2 / rho, x, row.a[j], curl);
    laplacian += w * (D - 3) / r2 * difference + 2 / rho * w * dot(x, sum) / r2 * difference;
    for (int c = 0; c < D; ++c) {
      gradient[c] += difference * w * x[c] / r2 / rho;
      for (int d = 0; d < D; ++d)
        hessian[c][d] += w / r2 * difference *
                         ((c == d) - 3 * x[c] * x[d] / r2 + (x[d] * sum[c] + x[c] * sum[d]) / rho);
    }
  }
  result.gradient.insert(result.gradient.end(), gradient.begin(), gradient.end());
  result.divergence.push_back(divergence);
  append_curl<D>(curl, result);
  result.laplacian.push_back(laplacian / rho);
  for (const auto& line : hessian)
    for (const long double entry : line) result.hessian.push_back(entry / rho);
}

template <class Dimension>
struct MpsAsSph : testing::Test {
  static constexpr int D = Dimension::value;
  using Operator = mote::MpsAsSph<D>;

  Points<D> points = jittered_cloud<D>({.side = usual_side<D>});
  std::vector<double> scalar = Draws(3).uniform(points.length.size(), -1, 1);
  std::vector<double> vector = Draws(4).uniform(points.position.size(), -1, 1);

  static Operator make_operator(double epsilon, PairLength length = PairLength::mean) {
    Operator op;
    Settings().with("smoothing_length", 2.6).with("epsilon", epsilon).apply_to(op);
    op.length = length;
    return op;
  }

  WideDerivatives expected(const Operator& op, double epsilon) const {
    const PrintedWeight<D> weight(epsilon);
    return paper_sums<D>(points, op.neighbour_rule(), scalar, vector,
                         [&](const Row<D>& row, WideDerivatives& result) {
                           add_limit_row(weight, points, row, result);
                         });
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MpsAsSph, Dimensions);

TYPED_TEST(MpsAsSph, EqualsThePrintedSumsForEveryPairLength) {
  for (const double epsilon : {0.01, 0.2})
    for (const PairLength length : pair_lengths) {
      auto op = TestFixture::make_operator(epsilon, length);
      const auto expected = this->expected(op, epsilon);
      const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
      EXPECT_TRUE(all_agree<TestFixture::D>(found, expected, tolerance));
    }
}

TYPED_TEST(MpsAsSph, SoftensByAHundredthWhereNothingIsSaid) {
  typename TestFixture::Operator op;
  const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
  EXPECT_TRUE(all_agree<TestFixture::D>(found, this->expected(op, 0.01), tolerance));
}

TYPED_TEST(MpsAsSph, CheckTellsTheSofteningsApart) {
  auto op = TestFixture::make_operator(0.01);
  const auto found = derivatives_of(op, this->points, this->scalar, this->vector);
  EXPECT_TRUE(none_agrees<TestFixture::D>(found, this->expected(op, 0.011), 1e-4));
}

TYPED_TEST(MpsAsSph, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  const auto op = TestFixture::make_operator(0.01);
  AlteredOperator<D, mote::MpsAsSph<D>> altered(op, 7, 1e-4);
  const auto found = derivatives_of(altered, this->points, this->scalar, this->vector);
  EXPECT_TRUE(none_agrees<D>(found, this->expected(op, 0.01), tolerance));
}

TYPED_TEST(MpsAsSph, RefusesCoincidentParticlesByName) {
  constexpr int D = TestFixture::D;
  auto& points = this->points;
  std::copy_n(points.position.begin() + 4 * D, D, points.position.begin() + 2 * D);
  auto op = TestFixture::make_operator(0.01);
  try {
    op.prepare(points, brute_force(points, op.neighbour_rule()));
    FAIL() << "the operator accepts these points";
  } catch (const NumericalFailure& failure) {
    EXPECT_THAT(failure.particles(), testing::ElementsAre(2));
    EXPECT_THAT(failure.what(), testing::HasSubstr("the sums of particle 2 are not finite"));
    EXPECT_THAT(failure.cause(), testing::HasSubstr("same place"));
  }
}

}  // namespace
}  // namespace mote::test
