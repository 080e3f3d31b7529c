#include "mote/operators/differential/corrected_sph.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include "kernel_cases.hpp"
#include "support/altered_operator.hpp"
#include "support/polynomial.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

constexpr PairLength pair_lengths[] = {PairLength::mean, PairLength::scatter, PairLength::gather};

template <int D>
using Wide = Eigen::Matrix<long double, D, 1>;
template <int D>
using WideMatrix = Eigen::Matrix<long double, D, D>;

/// The corrected operator of one receiver, in long double and for any tensor A, from its words:
/// Bonet & Lok's gradient B sum_j F x (f_j - f_i), and Fatehi & Manzari's
///   sum_j F (e^T A e - x . B sum_k F_k (e_k^T A e_k) x_k) (f_j - f_i).
template <int D>
class LiteralCorrection {
 public:
  template <class Kernel>
  LiteralCorrection(const Points<D>& points, const NeighbourRule& rule, const Kernel& kernel,
                    Index i, const std::vector<double>& values) {
    for (Index j = 0; j < points.size(); ++j) {
      if (!are_neighbours(points, rule, i, j)) continue;
      Wide<D> place;
      for (int d = 0; d < D; ++d)
        place[d] =
            static_cast<long double>(points.position[j * D + d]) - points.position[i * D + d];
      const long double h = wide_smoothing_length(points, rule, i, j);
      const auto q = static_cast<double>(wide_distance(points, i, j) / h);
      x_.push_back(place);
      slope_.push_back(-static_cast<long double>(points.mass[j]) / points.density[j] *
                       kernel.slope_over_q(q) / std::pow(h, D + 2));
      difference_.push_back(static_cast<long double>(values[j]) - values[i]);
    }
    WideMatrix<D> moment = WideMatrix<D>::Zero();
    for (std::size_t j = 0; j < x_.size(); ++j) moment += slope_[j] * x_[j] * x_[j].transpose();
    correction_ = moment.inverse();
  }

  Wide<D> gradient() const {
    Wide<D> sum = Wide<D>::Zero();
    for (std::size_t j = 0; j < x_.size(); ++j) sum += slope_[j] * difference_[j] * x_[j];
    return correction_ * sum;
  }

  /// sum_j l_ij (f_j - f_i) with sum_j l_ij x x^T = `moment`.
  long double second(const WideMatrix<D>& moment) const {
    constexpr int unknowns = D * (D + 1) / 2;
    WideMatrix<unknowns> conditions;
    Wide<unknowns> wanted, applied;
    int column = 0;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b, ++column) {
        WideMatrix<D> tensor = WideMatrix<D>::Zero();
        tensor(a, b) = tensor(b, a) = 1;
        const std::vector<long double> weight = weights_of(tensor);
        wanted[column] = moment(a, b);
        applied[column] = 0;
        WideMatrix<D> found = WideMatrix<D>::Zero();
        for (std::size_t j = 0; j < x_.size(); ++j) {
          found += weight[j] * x_[j] * x_[j].transpose();
          applied[column] += weight[j] * difference_[j];
        }
        int line = 0;
        for (int c = 0; c < D; ++c)
          for (int d = c; d < D; ++d) conditions(line++, column) = found(c, d);
      }
    return applied.dot(conditions.colPivHouseholderQr().solve(wanted));
  }

 private:
  std::vector<long double> weights_of(const WideMatrix<D>& tensor) const {
    const auto stretch = [&](const Wide<D>& x) { return x.dot(tensor * x) / x.squaredNorm(); };
    Wide<D> sum = Wide<D>::Zero();
    for (std::size_t k = 0; k < x_.size(); ++k) sum += slope_[k] * stretch(x_[k]) * x_[k];
    std::vector<long double> weights;
    for (std::size_t j = 0; j < x_.size(); ++j)
      weights.push_back(slope_[j] * (stretch(x_[j]) - x_[j].dot(correction_ * sum)));
    return weights;
  }

  std::vector<Wide<D>> x_;
  std::vector<long double> slope_, difference_;
  WideMatrix<D> correction_;
};

struct SecondOrder {
  std::vector<long double> gradient, laplacian, hessian;
};

template <int D, class Kernel>
SecondOrder literal_sums(const Points<D>& points, const NeighbourRule& rule, const Kernel& kernel,
                         const std::vector<double>& values) {
  SecondOrder result;
  for (Index i = 0; i < points.receivers; ++i) {
    const LiteralCorrection<D> sums(points, rule, kernel, i, values);
    const Wide<D> gradient = sums.gradient();
    result.gradient.insert(result.gradient.end(), gradient.begin(), gradient.end());
    result.laplacian.push_back(sums.second(2 * WideMatrix<D>::Identity()));
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) {
        WideMatrix<D> moment = WideMatrix<D>::Zero();
        moment(c, d) += 1;
        moment(d, c) += 1;
        result.hessian.push_back(sums.second(moment));
      }
  }
  return result;
}

/// Irregular points with varied masses, densities and lengths, boundaries included.
template <class Case>
struct CorrectedSph : testing::Test {
  static constexpr int D = Case::dimension;
  using Operator = mote::CorrectedSph<D, typename Case::Kernel>;

  Points<D> points = jittered_cloud<D>({.side = usual_side<D>});

  static Operator make_operator(PairLength length = PairLength::mean) {
    Operator op;
    op.smoothing_length = std::max(3.6 / op.kernel.support(), 0.8);
    op.length = length;
    return op;
  }
};
TYPED_TEST_SUITE(CorrectedSph, OperatorKernelCases, KernelCaseName);

/// The derivatives of polynomials of this degree, and what they are.
template <int D>
struct Comparison {
  Derivatives found, exact;

  Comparison(DifferentialOperator<D>& op, const Points<D>& points, int degree)
      : found(derivatives_of_polynomials(op, points, degree)),
        exact(PolynomialFields<D>(degree).derivatives(points)) {}

  bool gradient(double tolerance) const { return agree(found.gradient, exact.gradient, tolerance); }
  bool divergence(double tolerance) const {
    return agree(found.divergence, exact.divergence, tolerance);
  }
  bool curl(double tolerance) const { return agree(found.curl, exact.curl, tolerance); }
  bool laplacian(double tolerance) const {
    return agree(found.laplacian, exact.laplacian, tolerance);
  }
  bool hessian(double tolerance) const { return agree(found.hessian, exact.hessian, tolerance); }
};

TYPED_TEST(CorrectedSph, HasFirstDerivativesThatAreExactForLinearFields) {
  for (const PairLength length : pair_lengths) {
    auto op = TestFixture::make_operator(length);
    const Comparison linear(op, this->points, 1);
    EXPECT_TRUE(linear.gradient(1e-9));
    EXPECT_TRUE(linear.divergence(1e-9));
    EXPECT_TRUE(TestFixture::D == 1 || linear.curl(1e-9));
  }
}

TYPED_TEST(CorrectedSph, HasSecondDerivativesThatAreExactForParabolas) {
  for (const PairLength length : pair_lengths) {
    auto op = TestFixture::make_operator(length);
    const Comparison parabola(op, this->points, 2);
    EXPECT_TRUE(parabola.laplacian(1e-9));
    EXPECT_TRUE(parabola.hessian(1e-9));
  }
}

TYPED_TEST(CorrectedSph, IsNotExactForOneDegreeMore) {
  auto op = TestFixture::make_operator();
  const Comparison parabola(op, this->points, 2), cubic(op, this->points, 3);
  EXPECT_FALSE(parabola.gradient(1e-4));
  EXPECT_FALSE(parabola.divergence(1e-4));
  EXPECT_TRUE(TestFixture::D == 1 || !parabola.curl(1e-4));
  EXPECT_FALSE(cubic.laplacian(1e-4));
  EXPECT_FALSE(cubic.hessian(1e-4));
}

TYPED_TEST(CorrectedSph, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  AlteredOperator<D, typename TestFixture::Operator> altered(TestFixture::make_operator(), 7, 1e-5);
  const Comparison linear(altered, this->points, 1), parabola(altered, this->points, 2);
  EXPECT_FALSE(linear.gradient(1e-9));
  EXPECT_FALSE(linear.divergence(1e-9));
  EXPECT_TRUE(D == 1 || !linear.curl(1e-9));
  EXPECT_FALSE(parabola.laplacian(1e-9));
  EXPECT_FALSE(parabola.hessian(1e-9));
}

TYPED_TEST(CorrectedSph, EqualsTheCorrectionSolvedForInLongDouble) {
  constexpr int D = TestFixture::D;
  const auto values = Draws(3).uniform(this->points.length.size(), -1, 1);
  const auto vector = Draws(4).uniform(this->points.position.size(), -1, 1);
  auto op = TestFixture::make_operator();
  const auto expected = literal_sums<D>(this->points, op.neighbour_rule(), op.kernel, values);
  const auto found = derivatives_of<D>(op, this->points, values, vector);
  EXPECT_TRUE(agree(found.gradient, expected.gradient, 1e-10));
  EXPECT_TRUE(agree(found.laplacian, expected.laplacian, 1e-10));
  EXPECT_TRUE(agree(found.hessian, expected.hessian, 1e-10));
}

TYPED_TEST(CorrectedSph, IsNotTheCorrectionForOtherVolumes) {
  constexpr int D = TestFixture::D;
  const auto values = Draws(3).uniform(this->points.length.size(), -1, 1);
  const auto vector = Draws(4).uniform(this->points.position.size(), -1, 1);
  auto op = TestFixture::make_operator();
  const auto found = derivatives_of<D>(op, this->points, values, vector);
  this->points.mass.assign(this->points.mass.size(), 1);
  const auto expected = literal_sums<D>(this->points, op.neighbour_rule(), op.kernel, values);
  EXPECT_FALSE(agree(found.gradient, expected.gradient, 1e-3));
  EXPECT_FALSE(agree(found.laplacian, expected.laplacian, 1e-3));
  EXPECT_FALSE(agree(found.hessian, expected.hessian, 1e-3));
}

}  // namespace
}  // namespace mote::test
