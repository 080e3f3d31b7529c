// Sums over a lattice, and what the constants of a lattice do to mps.

#include "mote/operators/weights/lattice_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mote/operators/differential/mps.hpp"
#include "support/brute_force.hpp"
#include "support/clouds.hpp"
#include "support/dimensions.hpp"
#include "usual_clouds.hpp"

namespace mote::test {
namespace {

/// The points of a lattice but its origin, out to 5 spacings along each axis.
template <int D>
std::vector<Vec<D>> literal_lattice() {
  std::vector<Vec<D>> places;
  constexpr int side = 11;
  for (int k = 0; k < std::pow(side, D); ++k) {
    Vec<D> place;
    for (int d = 0, rest = k; d < D; ++d, rest /= side) place[d] = rest % side - 5;
    if (place != Vec<D>::Zero()) places.push_back(place);
  }
  return places;
}

/// Sum over the literal lattice of the places that are within a radius.
template <int D, class Term>
double literal_sum(double radius, Term term) {
  double sum = 0;
  for (const Vec<D>& place : literal_lattice<D>())
    if (place.norm() < radius) sum += term(place.norm());
  return sum;
}

template <class Dimension>
struct LatticeSum : testing::Test {};
TYPED_TEST_SUITE(LatticeSum, Dimensions, NameOfDimension);

TYPED_TEST(LatticeSum, IsThatOfAllPlacesWithinTheRadius) {
  constexpr int D = TypeParam::value;
  const auto term = [](double r) { return std::exp(-r) / r; };
  for (const double radius : {0.5, 1.5, 2.1, 3.1, 4.9}) {
    const double expected = literal_sum<D>(radius, term);
    EXPECT_NEAR(lattice_sum<D>(radius, term), expected, 1e-14 * (1 + expected)) << radius;
  }
}

TYPED_TEST(LatticeSum, HasTheRimInside) {
  constexpr int D = TypeParam::value;
  const auto one = [](double) { return 1.0; };
  EXPECT_EQ(lattice_sum<D>(1, one), 2 * D);
  EXPECT_EQ(lattice_sum<D>(3, one), literal_sum<D>(3.001, one));
  EXPECT_EQ(lattice_sum<D>(0.999, one), 0);  // the negative control
}

template <int D>
Mps<D> mps(MpsConstants constants, double smoothing_length = 2.6) {
  Mps<D> op;
  op.constants = constants;
  op.smoothing_length = smoothing_length;
  return op;
}

/// The weights l_ij of all pairs of points that are all receivers, 0 for no neighbours.
template <int D>
Eigen::MatrixXd laplacian_matrix(Mps<D> op, const Points<D>& points) {
  const NeighbourLists lists = brute_force(points, op.neighbour_rule());
  op.prepare(points, lists);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(points.size(), points.size());
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<double> row(lists[i].size());
    op.laplacian_weights(i, row);
    for (std::size_t k = 0; k < row.size(); ++k) matrix(i, lists[i][k]) = row[k];
  }
  return matrix;
}

template <class Dimension>
struct MpsOfLattice : testing::Test {
  static constexpr int D = Dimension::value;

  /// Points of one spacing, all of them receivers.
  static Points<D> points(double jitter) {
    auto points = jittered_cloud<D>({.side = usual_side<D>, .jitter = jitter, .variation = 0});
    points.receivers = points.size();
    return points;
  }
};
TYPED_TEST_SUITE(MpsOfLattice, Dimensions, NameOfDimension);

TYPED_TEST(MpsOfLattice, HasASymmetricLaplacianToTheLastBit) {
  constexpr int D = TypeParam::value;
  const auto op = mps<D>(MpsConstants::lattice);
  EXPECT_TRUE(op.has_symmetric_laplacian());
  const Eigen::MatrixXd matrix = laplacian_matrix<D>(op, this->points(0.2));
  EXPECT_GT(matrix.norm(), 1);
  EXPECT_TRUE(matrix == matrix.transpose());
}

/// Negative control: with constants of its own a particle's weights are not its neighbours'.
TYPED_TEST(MpsOfLattice, HasNoSymmetricLaplacianWithLocalConstants) {
  constexpr int D = TypeParam::value;
  const auto op = mps<D>(MpsConstants::local);
  EXPECT_FALSE(op.has_symmetric_laplacian());
  const Eigen::MatrixXd matrix = laplacian_matrix<D>(op, this->points(0.2));
  EXPECT_GT((matrix - matrix.transpose()).norm(), 1e-3 * matrix.norm());
}

/// The row of the point in the middle of a lattice, whose neighbours are all there.
template <int D>
Eigen::VectorXd inner_row(MpsConstants constants, const Points<D>& points) {
  Index middle = 0;
  const Vec<D> centre = Vec<D>::Constant((usual_side<D> - 1) / 2);
  for (Index i = 0; i < points.size(); ++i)
    if (points.at(i) == centre) middle = i;
  return laplacian_matrix<D>(mps<D>(constants, 1.9), points).row(middle);
}

TYPED_TEST(MpsOfLattice, HasLocalConstantsInsideALattice) {
  constexpr int D = TypeParam::value;
  const auto lattice = this->points(0);
  const Eigen::VectorXd own = inner_row<D>(MpsConstants::local, lattice),
                        common = inner_row<D>(MpsConstants::lattice, lattice);
  EXPECT_LT((own - common).norm(), 1e-14 * own.norm());
  // Negative control: on disorder they differ.
  const auto disorder = this->points(0.2);
  EXPECT_GT((laplacian_matrix<D>(mps<D>(MpsConstants::local), disorder) -
             laplacian_matrix<D>(mps<D>(MpsConstants::lattice), disorder))
                .norm(),
            1e-3);
}

TYPED_TEST(MpsOfLattice, HasTheLambdaOfALattice) {
  constexpr int D = TypeParam::value;
  const double h = 3.1;
  const double n = literal_sum<D>(h, [&](double r) { return h / r - 1; });
  const double moment = literal_sum<D>(h, [&](double r) { return r * r * (h / r - 1); });
  EXPECT_NEAR(mps<D>(MpsConstants::lattice, h).lattice_lambda(), moment / n, 1e-13);
  EXPECT_GT(std::abs(mps<D>(MpsConstants::lattice, 2.1).lattice_lambda() - moment / n), 0.1);
}

}  // namespace
}  // namespace mote::test
