#include "mote/operators/differential/least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <numeric>

#include "support/altered_operator.hpp"
#include "support/polynomial.hpp"

namespace mote::test {
namespace {

constexpr PairLength pair_lengths[] = {PairLength::mean, PairLength::scatter, PairLength::gather};

template <int D>
using Powers = std::array<int, D>;

/// The powers of all monomials of degree 1 to `degree`.
template <int D>
std::vector<Powers<D>> all_powers(int degree) {
  std::vector<Powers<D>> list{{}};
  for (int d = 0; d < D; ++d) {
    std::vector<Powers<D>> longer;
    for (Powers<D> powers : list)
      for (powers[d] = 0; std::reduce(powers.begin(), powers.end()) <= degree; ++powers[d])
        longer.push_back(powers);
    list = longer;
  }
  std::erase(list, Powers<D>{});
  return list;
}

/// The polynomial through one receiver that fits its neighbours best, in long double, by
/// Householder reflections with pivoting.
template <int D>
class LiteralFit {
 public:
  LiteralFit(const Points<D>& points, const NeighbourRule& rule, Index i, int degree,
             const std::vector<double>& values)
      : powers_(all_powers<D>(degree)) {
    std::vector<Index> neighbours;
    for (Index j = 0; j < points.size(); ++j)
      if (are_neighbours(points, rule, i, j)) neighbours.push_back(j);
    Eigen::Matrix<long double, -1, -1> matrix(neighbours.size(), powers_.size());
    Eigen::Matrix<long double, -1, 1> wanted(neighbours.size());
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const Index j = neighbours[k];
      const long double q = wide_distance(points, i, j) / wide_smoothing_length(points, rule, i, j);
      const long double root = std::pow(std::max(0.0L, 1 - q * q), 3);  // of (1 - q^2)^6
      wanted[k] = root * (static_cast<long double>(values[j]) - values[i]);
      for (std::size_t a = 0; a < powers_.size(); ++a) {
        matrix(k, a) = root;
        for (int d = 0; d < D; ++d)
          matrix(k, a) *= std::pow(
              static_cast<long double>(points.position[j * D + d]) - points.position[i * D + d],
              powers_[a][d]);
      }
    }
    coefficients_ = matrix.colPivHouseholderQr().solve(wanted);
  }

  void add_to(Derivatives& result) const {
    result.laplacian.push_back(0);
    for (int c = 0; c < D; ++c) {
      result.gradient.push_back(static_cast<double>(derivative({c})));
      for (int d = 0; d < D; ++d) result.hessian.push_back(static_cast<double>(derivative({c, d})));
      result.laplacian.back() += static_cast<double>(derivative({c, c}));
    }
  }

 private:
  /// The derivative by these coordinates: a coefficient times the factorials of its powers.
  long double derivative(std::initializer_list<int> coordinates) const {
    Powers<D> powers{};
    long double factor = 1;
    for (const int d : coordinates) factor *= ++powers[d];
    return factor * coefficients_[std::ranges::find(powers_, powers) - powers_.begin()];
  }

  std::vector<Powers<D>> powers_;
  Eigen::Matrix<long double, -1, 1> coefficients_;
};

template <int D, int Degree>
struct FitCase {
  static constexpr int dimension = D, degree = Degree;
};
using FitCases =
    testing::Types<FitCase<1, 2>, FitCase<1, 3>, FitCase<1, 4>, FitCase<2, 2>, FitCase<2, 3>,
                   FitCase<2, 4>, FitCase<3, 2>, FitCase<3, 3>, FitCase<3, 4>>;

struct FitCaseName {
  template <class Case>
  static std::string GetName(int) {
    return std::to_string(Case::dimension) + "d_" + std::to_string(Case::degree);
  }
};

/// Irregular points of varied lengths, boundaries included.
template <class Case>
struct LeastSquares : testing::Test {
  static constexpr int D = Case::dimension, degree = Case::degree;
  using Operator = mote::LeastSquares<D, degree>;

  Points<D> points =
      jittered_cloud<D>({.side = D == 1 ? 20 : (D == 2 ? 12 : 6), .jitter = 0.2, .variation = 0.1});

  static Operator make_operator(PairLength length = PairLength::mean) {
    Operator op;
    op.smoothing_length = degree + 1.5;
    op.length = length;
    return op;
  }
};
TYPED_TEST_SUITE(LeastSquares, FitCases, FitCaseName);

TYPED_TEST(LeastSquares, IsExactUpToItsDegree) {
  for (const PairLength length : pair_lengths)
    for (int degree = 2; degree <= TestFixture::degree; ++degree) {
      auto op = TestFixture::make_operator(length);
      EXPECT_TRUE(is_exact(op, this->points, degree, 1e-10));
    }
}

TYPED_TEST(LeastSquares, IsNotExactForOneDegreeMore) {
  auto op = TestFixture::make_operator();
  EXPECT_TRUE(is_nowhere_exact(op, this->points, TestFixture::degree + 1, 1e-5));
}

TYPED_TEST(LeastSquares, CheckNoticesOneAlteredWeight) {
  constexpr int D = TestFixture::D;
  AlteredOperator<D, typename TestFixture::Operator> altered(TestFixture::make_operator(), 7, 1e-5);
  EXPECT_TRUE(is_nowhere_exact(altered, this->points, 2, 1e-10));
}

TYPED_TEST(LeastSquares, EqualsTheFitByHouseholderReflections) {
  constexpr int D = TestFixture::D;
  const auto values = Draws(3).uniform(this->points.length.size(), -1, 1);
  const auto vector = Draws(4).uniform(this->points.position.size(), -1, 1);
  for (const PairLength length : pair_lengths) {
    auto op = TestFixture::make_operator(length);
    Derivatives expected;
    for (Index i = 0; i < this->points.receivers; ++i)
      LiteralFit<D>(this->points, op.neighbour_rule(), i, TestFixture::degree, values)
          .add_to(expected);
    const auto found = derivatives_of<D>(op, this->points, values, vector);
    EXPECT_TRUE(agree(found.gradient, expected.gradient, 1e-10));
    EXPECT_TRUE(agree(found.laplacian, expected.laplacian, 1e-10));
    EXPECT_TRUE(agree(found.hessian, expected.hessian, 1e-10));
  }
}

TYPED_TEST(LeastSquares, IsNotTheFitWithinAnotherRadius) {
  constexpr int D = TestFixture::D;
  const auto values = Draws(3).uniform(this->points.length.size(), -1, 1);
  const auto vector = Draws(4).uniform(this->points.position.size(), -1, 1);
  auto op = TestFixture::make_operator();
  Derivatives expected;
  for (Index i = 0; i < this->points.receivers; ++i)
    LiteralFit<D>(this->points, op.neighbour_rule(), i, TestFixture::degree, values)
        .add_to(expected);
  op.smoothing_length *= 1.01;
  const auto found = derivatives_of<D>(op, this->points, values, vector);
  EXPECT_FALSE(agree(found.gradient, expected.gradient, 1e-4));
  EXPECT_FALSE(agree(found.laplacian, expected.laplacian, 1e-4));
  EXPECT_FALSE(agree(found.hessian, expected.hessian, 1e-4));
}

// All neighbours of a corner are on its one side in every direction, here within the usual radius.
// The farthest layer that the fit needs has a small weight there: that costs a few digits.
TYPED_TEST(LeastSquares, IsExactInTheCornerOfAFreeBoundary) {
  constexpr int D = TestFixture::D;
  auto points = jittered_cloud<D>({.side = D == 3 ? 6 : 12, .jitter = 0.05, .variation = 0});
  Index corner = 0;
  for (Index i = 0; i < points.size(); ++i)
    if (points.at(i).sum() < points.at(corner).sum()) corner = i;
  for (int d = 0; d < D; ++d) {
    std::swap(points.position[d], points.position[corner * D + d]);
    points.position[d] = -0.1;
  }
  points.receivers = 1;
  typename TestFixture::Operator op;
  EXPECT_TRUE(is_exact<D>(op, points, TestFixture::degree, 1e-8));
  EXPECT_TRUE(is_nowhere_exact<D>(op, points, TestFixture::degree + 1, 1e-5));
}

}  // namespace
}  // namespace mote::test
