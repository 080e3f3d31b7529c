// What the formulas of Tabanjeh (2014) without Vandermonde matrices, (13) and (14), and for the
// degenerate matrix, lemma 5.2 and remark 8.1, keep of double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sums/cauchy_matrices.hpp"

namespace mote::test {
namespace {

using Of = CauchyMatrices<double>;
using Matrix = Of::Matrix;
using Vector = Of::Vector;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The larger error of (13) and (14) for points at radii from 1 - width to 1 + width, with roots of
/// unity between them; the worst of some draws.
double error_of_roots_of_unity(Eigen::Index count, double width) {
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Draws draws(seed);
    const Vector s = points_around<double>(draws, count, 1 - width, 1 + width);
    const Vector t = points_around<double>(draws, count, 1 - width, 1 + width);
    const Matrix right = Of::cauchy(s, t);
    for (const Matrix& found :
         {Of::equation_6(s, t, Of::roots(count)), Of::equation_8(s, t, Of::roots(count))})
      worst = std::max(worst, Of::difference(found, right));
  }
  return worst;
}

/// The products D(u, v) stay of one size on the circle.
TEST(CauchyStability, RootsOfUnityServePointsNearTheCircle) {
  for (const Eigen::Index count : {12, 24, 48})
    EXPECT_LE(error_of_roots_of_unity(count, 0.05), 100 * epsilon) << count;
}

/// Off the circle they grow as powers of the radii, and the error doubles its digits with the
/// points: no way to sum thousands.
TEST(CauchyStability, RootsOfUnityFailPointsOffTheCircle) {
  const double at_24 = error_of_roots_of_unity(24, 0.8), at_48 = error_of_roots_of_unity(48, 0.8);
  EXPECT_GE(at_24, 1e3 * epsilon);
  EXPECT_GE(at_48, 1e6 * epsilon);
  EXPECT_GE(at_48 / at_24, 100);
}

/// Lemma 5.2: the mean of the Cauchy matrices of points moved onto `count` places of a circle.
Matrix mean_over_circle(const Vector& s, double radius, Eigen::Index count) {
  Matrix sum = Matrix::Zero(s.size(), s.size());
  for (const auto root : Of::roots(count, radius)) sum += Of::cauchy(s, s.array() + root);
  return sum / double(count);
}

struct DegenerateMatrix : testing::Test {
  Draws draws{3};
  Vector s = points_around<double>(draws, 12, 0.9, 1.1);

  double least_gap() const { return 1 / Of::degenerate(s).cwiseAbs().maxCoeff(); }
  /// With the radius as a part of the least gap.
  double error(double part, Eigen::Index count) const {
    return Of::difference(mean_over_circle(s, part * least_gap(), count), Of::degenerate(s));
  }
};

/// For points d apart the mean over h roots is 1/d/(1 - (delta/d)^h): the geometric series without
/// the terms that Lemma 5.1 cancels. On the diagonal it is 0.
TEST_F(DegenerateMatrix, IsAMeanButForAPowerOfTheRadius) {
  for (const Eigen::Index count : {4, 8, 16})
    for (const double part : {0.5, 0.3}) {
      const double power = std::pow(part, count);
      EXPECT_GE(error(part, count), 0.8 * power) << count << " " << part;
      EXPECT_LE(error(part, count), power / (1 - power) + 100 * epsilon) << count << " " << part;
    }
}

/// Entries of size 1/delta cancel on the diagonal and leave eps/delta: as delta goes to 0 the error
/// does not, and a radius of a tenth of the least gap or more with 16 roots is best.
TEST_F(DegenerateMatrix, LosesDigitsAsTheRadiusVanishes) {
  for (const double part : {1e-2, 1e-4, 1e-6}) {
    EXPECT_LE(error(part, 16), 10 * epsilon / part) << part;
    EXPECT_GE(error(part, 16), 0.01 * epsilon / part) << part;
  }
  EXPECT_LE(error(0.1, 16), 100 * epsilon);
  EXPECT_GE(error(1e-6, 16), 1e4 * epsilon);
}

/// The control: with a root left out nothing cancels.
TEST_F(DegenerateMatrix, NeedsAllRoots) {
  const double radius = 0.1 * least_gap();
  const Matrix missing = mean_over_circle(s, radius, 16) - Of::cauchy(s, s.array() + radius) / 16;
  EXPECT_GE(Of::difference(missing, Of::degenerate(s)), 0.1);
}

}  // namespace
}  // namespace mote::test
