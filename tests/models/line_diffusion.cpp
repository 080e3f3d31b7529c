#include "mote/models/line_diffusion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <memory>

#include "mote/neighbours/line.hpp"
#include "mote/operators/differential/finite_difference.hpp"
#include "mote/operators/differential/morris.hpp"
#include "mote/operators/kernels/gauss.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/layouts.hpp"

namespace mote::test {
namespace {

using Operator = DifferentialOperator<1>;
using Numbers = std::vector<double>;

/// A line of unequal cells between 0 and 1 with one operator prepared on it.
struct Line {
  Cells cells = cells_of_line<Random>(0, 1, 24, 5);
  LineExtension extension;
  Points<1> points;
  NeighbourLists lists;
  std::unique_ptr<Operator> op;

  explicit Line(LineEnds ends, std::unique_ptr<Operator> made = three_points())
      : extension(static_cast<Index>(std::ceil(made->neighbour_rule().reach())), ends, 0, 1),
        op(std::move(made)) {
    const Numbers one(cells.centre.size(), 1.0);
    extension.extend({cells.centre, cells.length, one, cells.length}, points);
    LineSearch().find(points, op->neighbour_rule(), lists);
    op->prepare(points, lists);
  }

  static std::unique_ptr<Operator> three_points() {
    return std::make_unique<FiniteDifference<1>>();
  }
  static std::unique_ptr<Operator> morris() { return std::make_unique<Morris<1, Gauss<1>>>(); }

  std::unique_ptr<LineDiffusion> diffusion() const {
    auto diffusion = std::make_unique<LineDiffusion>();
    diffusion->assemble(*op, lists, extension);
    return diffusion;
  }

  /// 0 at the ends, as walls want it.
  Numbers wave() const {
    Numbers values;
    for (const double x : cells.centre) values.push_back(x * (1 - x) * (3 + 2 * std::cos(5 * x)));
    return values;
  }

  /// d/dt of the values by the operator's weights, receiver by receiver.
  Eigen::MatrixXd matrix() const {
    const auto count = static_cast<Index>(cells.centre.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
    for (Index column = 0; column < count; ++column) {
      Numbers unit(cells.centre.size()), extended(points.length.size());
      unit[column] = 1;
      extension.fill(unit, extended, Parity::odd);
      for (Index i = 0; i < count; ++i) {
        Numbers weights(lists[i].size());
        op->laplacian_weights(i, weights);
        for (std::size_t k = 0; k < weights.size(); ++k)
          matrix(i, column) += weights[k] * (extended[lists[i][k]] - extended[i]);
      }
    }
    if (extension.ends() == LineEnds::held) matrix.row(0).setZero();
    if (extension.ends() == LineEnds::held) matrix.row(count - 1).setZero();
    return matrix;
  }

  /// The solution after `amount`, by the eigenvectors of the matrix.
  Numbers exact(double amount) const {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix());
    const Numbers start = wave();
    const Eigen::Map<const Eigen::VectorXd> u(start.data(), matrix().rows());
    const Eigen::VectorXcd parts =
        solver.eigenvectors().fullPivLu().solve(u.cast<std::complex<double>>());
    const Eigen::VectorXcd grown = (amount * solver.eigenvalues()).array().exp() * parts.array();
    const Eigen::VectorXd end = (solver.eigenvectors() * grown).real();
    return {end.begin(), end.end()};
  }
};

enum class Scheme { implicit, substepped };

double largest_error(const Line& line, Scheme scheme, double amount, int steps) {
  const auto diffusion = line.diffusion();
  Numbers values = line.wave();
  for (int k = 0; k < steps; ++k) {
    if (scheme == Scheme::implicit) diffusion->advance_implicitly(amount / steps, values);
    if (scheme == Scheme::substepped) diffusion->advance_in_substeps(amount / steps, values);
  }
  const Numbers exact = line.exact(amount);
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    largest = std::max(largest, std::abs(values[i] - exact[i]));
  return largest;
}

struct EveryEnd : testing::TestWithParam<LineEnds> {};

TEST_P(EveryEnd, ImplicitDiffusionHasOrderTwo) {
  for (auto made : {Line::three_points, Line::morris}) {
    const Line line(GetParam(), made());
    const double coarse = largest_error(line, Scheme::implicit, 0.01, 40);
    const double fine = largest_error(line, Scheme::implicit, 0.01, 80);
    EXPECT_LT(fine, 2e-6);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
  }
}

TEST_P(EveryEnd, SubStepsAgreeWithTheExactSolutionToo) {
  const Line line(GetParam());
  const double error = largest_error(line, Scheme::substepped, 0.01, 1);
  EXPECT_LT(error, 1e-3);
  EXPECT_GT(error, 1e-12);
  EXPECT_LT(largest_error(line, Scheme::substepped, 0.01, 4000), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(, EveryEnd,
                         testing::Values(LineEnds::zero_gradient, LineEnds::held, LineEnds::wall),
                         [](const auto& ends) {
                           return ends.param == LineEnds::held   ? "held"
                                  : ends.param == LineEnds::wall ? "wall"
                                                                 : "zero_gradient";
                         });

/// What is left when a wave has diffused for ever, in one implicit step.
Numbers after_for_ever(LineEnds ends) {
  const Line line(ends);
  Numbers values = line.wave();
  line.diffusion()->advance_implicitly(1e9, values);
  return values;
}

TEST(LineDiffusion, EndsAsTheEndsDemand) {
  const Line line(LineEnds::held);
  const Numbers wave = line.wave(), held = after_for_ever(LineEnds::held);
  const double slope =
      (wave.back() - wave.front()) / (line.cells.centre.back() - line.cells.centre.front());
  for (std::size_t i = 0; i < held.size(); ++i)
    EXPECT_NEAR(held[i], wave[0] + slope * (line.cells.centre[i] - line.cells.centre[0]), 1e-7);
  const Numbers free = after_for_ever(LineEnds::zero_gradient);
  for (const double value : free) EXPECT_NEAR(value, free.front(), 1e-6);
  EXPECT_GT(std::abs(free.front()), 0.1);
  for (const double value : after_for_ever(LineEnds::wall)) EXPECT_NEAR(value, 0, 1e-7);
}

TEST(LineDiffusion, TakesSubStepsWithinGershgorinsBound) {
  const Line line(LineEnds::zero_gradient);
  const double limit = 1 / largest_row_sum(*line.op, line.lists, LineEnds::zero_gradient).sum;
  const auto diffusion = line.diffusion();
  Numbers values = line.wave();
  EXPECT_EQ(diffusion->advance_in_substeps(0.9 * limit, values), 1);
  EXPECT_EQ(diffusion->advance_in_substeps(9.5 * limit, values), 10);
  for (int k = 0; k < 2000; ++k) diffusion->advance_in_substeps(limit, values);
  for (const double value : values) EXPECT_LT(std::abs(value), 2);
}

TEST(LineDiffusion, HasTheKnownLimitOnARegularLine) {
  Line line(LineEnds::zero_gradient);
  const Cells regular = cells_of_line<Regular>(0, 1, 24, 0);
  line.extension.extend({regular.centre, regular.length, regular.length, regular.length},
                        line.points);
  LineSearch().find(line.points, line.op->neighbour_rule(), line.lists);
  line.op->prepare(line.points, line.lists);
  EXPECT_NEAR(largest_row_sum(*line.op, line.lists, LineEnds::zero_gradient).sum, 2 * 24 * 24,
              1e-9);
}

TEST(LineDiffusion, OfNothingChangesNothing) {
  const Line line(LineEnds::zero_gradient);
  const auto diffusion = line.diffusion();
  for (const double amount : {0.0, 5e-324}) {
    Numbers values = line.wave();
    diffusion->advance_implicitly(amount, values);
    EXPECT_EQ(values, line.wave());
  }
}

TEST(LineDiffusion, RefusesMoreThanAMillionSubStepsByTheNameOfTheParticle) {
  const Line line(LineEnds::zero_gradient);
  const auto largest = largest_row_sum(*line.op, line.lists, LineEnds::zero_gradient);
  Numbers values = line.wave();
  try {
    line.diffusion()->advance_in_substeps(2e6 / largest.sum, values);
    ADD_FAILURE() << "it took them";
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.particles(), std::vector<Index>{largest.receiver});
  }
}

// Beyond the limit explicit steps grow: the limit is not a cautious guess.
TEST(LineDiffusion, LimitIsSharpUpToTheGershgorinBound) {
  const Line line(LineEnds::zero_gradient);
  const double limit = 1 / largest_row_sum(*line.op, line.lists, LineEnds::zero_gradient).sum;
  const double fastest = -line.matrix().eigenvalues().real().minCoeff();
  EXPECT_LE(fastest * limit, 2 + 1e-12);
  EXPECT_GT(fastest * limit, 1);
}

}  // namespace
}  // namespace mote::test
