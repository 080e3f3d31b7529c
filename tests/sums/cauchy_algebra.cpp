// The identities between Cauchy matrices of Tabanjeh (2014), as corrected, with the print where it
// is wrong.

#include <gtest/gtest.h>

#include <limits>

#include "sums/cauchy_matrices.hpp"

namespace mote::test {
namespace {

using Real = long double;
using Of = CauchyMatrices<Real>;
using Matrix = Of::Matrix;
using Vector = Of::Vector;

/// The Vandermonde matrices of up to 12 points around a circle have condition numbers of some 1e4.
constexpr Real tolerance = 1e6L * std::numeric_limits<Real>::epsilon();

/// A wrong formula is wrong altogether.
constexpr Real wrong = 0.1L;

class CauchyAlgebra : public testing::TestWithParam<Eigen::Index> {
 protected:
  Draws draws{static_cast<std::uint64_t>(GetParam())};
  const Eigen::Index n = GetParam();
  const Vector b = points_around<Real>(draws, n, 0.8, 0.9);
  const Vector c = points_around<Real>(draws, n, 0.95, 1.05);
  const Vector d = points_around<Real>(draws, n, 1.1, 1.2);
  const Matrix right = Of::cauchy(c, d);
  const Matrix inverse_of_c_d = Of::polynomial(c, d).inverse();
};

INSTANTIATE_TEST_SUITE_P(Points, CauchyAlgebra, testing::Values(6, 9, 12));

/// (2), corrected: x_i^n - 1 in place of 1 - x_i^n. F is V(w)/sqrt(n), with the roots of unity w.
TEST_P(CauchyAlgebra, EquationTwoIsThatOfAVandermondeMatrix) {
  const Vector w = Of::roots(n);
  const Matrix powers = c.array().pow(Real(n)).matrix().asDiagonal();
  const Matrix one = Matrix::Identity(n, n), in_the_middle = w.asDiagonal();
  const auto of = [&](const Matrix& diagonal) -> Matrix {
    return diagonal * Of::cauchy(c, w) * in_the_middle * Of::vandermonde(w) / Real(n);
  };
  EXPECT_LE(Of::difference(of(powers - one), Of::vandermonde(c)), tolerance);
  EXPECT_GE(Of::difference(of(one - powers), Of::vandermonde(c)), wrong);
}

/// (3), corrected: the Hankel matrix is that of the coefficients of p_d, and not of d.
TEST_P(CauchyAlgebra, EquationThreeHasTheCoefficientsInAHankelMatrix) {
  const auto of = [&](const Vector& entries) -> Matrix {
    return inverse_of_c_d * Of::vandermonde(c) * Of::hankel(entries) *
           Of::vandermonde(d).transpose();
  };
  EXPECT_LE(Of::difference(of(Of::upper_coefficients(d)), right), tolerance);
  EXPECT_GE(Of::difference(of(d), right), wrong);
}

TEST_P(CauchyAlgebra, EquationFourInterpolates) {
  const Matrix found =
      inverse_of_c_d * Of::vandermonde(c) * Of::vandermonde(d).inverse() * Of::slope(d);
  EXPECT_LE(Of::difference(found, right), tolerance);
}

TEST_P(CauchyAlgebra, EquationFiveChangesABasis) {
  const Matrix found = inverse_of_c_d * Of::vandermonde(c) * Of::vandermonde(b).inverse() *
                       Of::polynomial(b, d) * Of::cauchy(b, d);
  EXPECT_LE(Of::difference(found, right), tolerance);
}

/// (7), corrected: V(b)^-T and D(d, c)^-1, where the print has no inverse.
TEST_P(CauchyAlgebra, EquationSevenChangesTheOtherBasis) {
  const Matrix front = Of::cauchy(c, b) * Of::polynomial(b, c);
  const Matrix vandermonde_of_b = Of::vandermonde(b).transpose();
  const Matrix vandermonde_of_d = Of::vandermonde(d).transpose();
  const Matrix end = Of::polynomial(d, c);
  EXPECT_LE(
      Of::difference(front * vandermonde_of_b.inverse() * vandermonde_of_d * end.inverse(), right),
      tolerance);
  EXPECT_GE(Of::difference(front * vandermonde_of_b * vandermonde_of_d * end, right), wrong);
}

TEST_P(CauchyAlgebra, EquationsSixAndEightNeedNoVandermondeMatrix) {
  EXPECT_LE(Of::difference(Of::equation_6(c, d, b), right), tolerance);
  EXPECT_LE(Of::difference(Of::equation_8(c, d, b), right), tolerance);
  // The control: without its sign (8) is false, and so is (6) with the bases in the wrong place.
  EXPECT_GE(Of::difference(-Of::equation_8(c, d, b), right), wrong);
  EXPECT_GE(Of::difference(Of::equation_6(d, c, b), right), wrong);
}

TEST_P(CauchyAlgebra, EquationsThirteenAndFourteenTakeRootsOfUnity) {
  const Vector q = Of::roots(n, 0.5L);
  EXPECT_LE(Of::difference(Of::equation_6(c, d, q), right), tolerance);
  EXPECT_LE(Of::difference(Of::equation_8(c, d, q), right), tolerance);
}

}  // namespace
}  // namespace mote::test
