#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "mote/particles/failure.hpp"
#include "mote/solvers/linear_solver.hpp"
#include "support/poisson.hpp"

namespace mote::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Values = std::vector<double>;

const SparseMatrix& small_matrix() {
  static const SparseMatrix matrix = poisson_matrix<2>({.side = 30});
  return matrix;
}

/// What a solver says that fails.
template <class Failure = NumericalFailure>
Failure failure(const std::string& solver, const SolverOptions& options, const SparseMatrix& matrix,
                const Values& right_side, Values guess) {
  try {
    make_linear_solver(solver, options)->solve(matrix, right_side, guess);
  } catch (const Failure& caught) {
    return caught;
  }
  throw std::logic_error("it does not fail");
}

Values right_side() { return rough_and_smooth(static_cast<Index>(small_matrix().rows())); }
Values zeros() { return Values(right_side().size()); }

TEST(LinearSolver, SaysHowFarItCame) {
  for (const bool symmetric : {true, false})
    for (const auto& solver : solver_names()) {
      const auto found = failure(solver.name,
                                 {.symmetric = symmetric,
                                  .tolerance = 1e-13,
                                  .most_iterations = 3,
                                  .name = "the pressure"},
                                 small_matrix(), right_side(), zeros());
      EXPECT_THAT(found.what(), AllOf(HasSubstr("the pressure was not solved: 3 iterations"),
                                      HasSubstr("1e-13 was asked for (it went 1, ")));
      EXPECT_THAT(found.cause(), HasSubstr("too few iterations"));
    }
}

TEST(LinearSolver, ShowsTheFirstResidualsAndTheLast) {
  const std::string text =
      failure("eigen", {.most_iterations = 20}, small_matrix(), right_side(), zeros()).what();
  EXPECT_THAT(text, HasSubstr(", ..., "));
  EXPECT_EQ(std::ranges::count(text.substr(text.find("(it went")), ','), 6) << text;
}

TEST(LinearSolver, RefusesWhatPrecisionCannotGive) {
  for (const auto& solver : solver_names()) {
    for (const double tolerance : {1e-15, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
      EXPECT_THAT(failure<InputError>(solver.name, {.tolerance = tolerance}, small_matrix(),
                                      right_side(), zeros())
                      .what(),
                  HasSubstr("beyond double precision"));
    // Rounding may forbid a tolerance that is not refused; then it says so and does not go on.
    Values x = zeros();
    try {
      make_linear_solver(solver.name, {.tolerance = 1e-14})->solve(small_matrix(), right_side(), x);
    } catch (const NumericalFailure& caught) {
      EXPECT_THAT(caught.cause(), HasSubstr("rounding does not allow"));
    }
  }
}

TEST(LinearSolver, GivesZeroForZeroAtOnce) {
  for (const bool singular : {false, true})
    for (const auto& solver : solver_names()) {
      Values x = right_side();
      const auto result = make_linear_solver(solver.name, {.singular = singular})
                              ->solve(small_matrix(), Values(x.size(), singular ? 0.1 : 0.0), x);
      EXPECT_EQ(x, zeros());
      EXPECT_EQ(result.iterations, 0);
      EXPECT_EQ(result.setup_seconds, 0);
      EXPECT_NEAR(result.removed_mean, singular ? 0.1 : 0, 1e-15);
    }
}

TEST(LinearSolver, NamesTheRowThatIsWrong) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& solver : solver_names()) {
    const auto row_of = [&](const SparseMatrix& matrix, const Values& b, const Values& guess) {
      return failure(solver.name, {}, matrix, b, guess).particles();
    };
    Values wrong = right_side();
    wrong[17] = nan;
    EXPECT_THAT(row_of(small_matrix(), wrong, zeros()), testing::ElementsAre(17));
    EXPECT_THAT(row_of(small_matrix(), right_side(), wrong), testing::ElementsAre(17));
    for (const double diagonal : {0.0, -1.0, nan}) {
      SparseMatrix matrix = small_matrix();
      matrix.coeffRef(23, 23) = diagonal;
      EXPECT_THAT(row_of(matrix, right_side(), zeros()), testing::ElementsAre(23));
    }
  }
}

/// A tenth of the diagonal: a constant right side meets negative eigenvalues at once.
TEST(LinearSolver, NoticesThatAMatrixIsNotPositive) {
  SparseMatrix matrix = small_matrix();
  for (Index i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) *= 0.1;
  for (const auto& solver : solver_names())
    EXPECT_THAT(failure(solver.name, {}, matrix, Values(zeros().size(), 1.0), zeros()).cause(),
                HasSubstr("not symmetric and positive"));
}

TEST(LinearSolver, TakesVectorsThatFitOnly) {
  const auto solver = make_linear_solver("eigen", {});
  Values b = right_side(), x = zeros();
  x.pop_back();
  EXPECT_THROW(solver->solve(small_matrix(), b, x), std::invalid_argument);
}

TEST(LinearSolver, HasAName) {
  EXPECT_THROW(make_linear_solver("gauss", {}), InputError);
  EXPECT_EQ(solver_names().back().name, "eigen");
}

TEST(LinearSolver, TakesSystemsOfNoneAndOne) {
  for (const auto& solver : solver_names()) {
    Values x;
    EXPECT_EQ(
        make_linear_solver(solver.name, {})->solve(SparseMatrix(0, 0), Values(), x).iterations, 0);
    SparseMatrix one(1, 1);
    one.insert(0, 0) = 4;
    one.makeCompressed();
    x = {0};
    make_linear_solver(solver.name, {})->solve(one, Values{2}, x);
    EXPECT_EQ(x, Values{0.5});
  }
}

}  // namespace
}  // namespace mote::test
