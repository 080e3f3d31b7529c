#include "mote/quantum/stationary_states.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "mote/particles/failure.hpp"
#include "mote/quantum/gauss_rules.hpp"

namespace mote {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Enough for squares of quartics times polynomials of degree 11, and potentials that are smooth.
constexpr int places_a_piece = 10;

double node(const SchroedingerProblem& problem, int i) {
  return problem.lower + (problem.upper - problem.lower) * i / problem.intervals;
}

WaveInterval interval(const SchroedingerProblem& problem, int i) {
  return {problem.form, node(problem, i), node(problem, i + 1)};
}

WaveTail tail_below(const SchroedingerProblem& problem) {
  return {problem.form, problem.lower, -1, *problem.decay_below};
}
WaveTail tail_above(const SchroedingerProblem& problem) {
  return {problem.form, problem.upper, 1, *problem.decay_above};
}

/// integral of a b and of a (b'' - V b), for the functions a, b of a piece at one place of it.
template <class Block, class Functions>
void add_products(const Functions& functions, double potential, double weight, Block p, Block q) {
  for (std::size_t a = 0; a < functions.size(); ++a)
    for (std::size_t b = 0; b < functions.size(); ++b) {
      const auto row = static_cast<Eigen::Index>(a), column = static_cast<Eigen::Index>(b);
      p(row, column) += weight * functions[a].value * functions[b].value;
      q(row, column) +=
          weight * functions[a].value * (functions[b].bend - potential * functions[b].value);
    }
}

void add_interval(const SchroedingerProblem& problem, int i, MatrixXd& p, MatrixXd& q) {
  static const GaussRule rule = gauss_legendre(places_a_piece);
  const WaveInterval piece = interval(problem, i);
  const double length = piece.upper - piece.lower;
  for (int k = 0; k < places_a_piece; ++k) {
    const double x = piece.lower + length * rule.place[k];
    add_products(piece.functions(x), problem.potential(x), length * rule.weight[k],
                 p.block(2 * i, 2 * i, 4, 4), q.block(2 * i, 2 * i, 4, 4));
  }
}

/// The square of a tail has the exponential e^-2ky, which the rule takes as its weight.
void add_tail(const SchroedingerProblem& problem, const WaveTail& tail, int value, MatrixXd& p,
              MatrixXd& q) {
  static const GaussRule rule = gauss_laguerre(places_a_piece);
  for (int k = 0; k < places_a_piece; ++k) {
    const double distance = rule.place[k] / (2 * tail.decay);
    add_products(std::array{tail.factor(distance)},
                 problem.potential(tail.end + tail.direction * distance),
                 rule.weight[k] / (2 * tail.decay), p.block(value, value, 1, 1),
                 q.block(value, value, 1, 1));
  }
}

/// Values and slopes at all nodes of the unknowns: where psi is 0 its slope, where it has a tail
/// its value.
MatrixXd nodal_of_unknowns(const SchroedingerProblem& problem) {
  const int all = 2 * (problem.intervals + 1), last = 2 * problem.intervals;
  MatrixXd nodal = MatrixXd::Zero(all, all - 2);
  nodal.block(2, 1, all - 4, all - 4).setIdentity();
  if (problem.decay_below)
    nodal.col(0).head(2) << 1, tail_below(problem).factor(0).slope;
  else
    nodal(1, 0) = 1;
  if (problem.decay_above)
    nodal.col(all - 3).segment(last, 2) << 1, tail_above(problem).factor(0).slope;
  else
    nodal(last + 1, all - 3) = 1;
  return nodal;
}

NumericalFailure not_solved(const std::string& problem) {
  return {problem,
          {},
          "the domain, the decay or the potential is too large or too small for numbers of 16 "
          "digits; units in which they are near 1 are best"};
}

Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solved(const SchroedingerMatrices& matrices) {
  if (!matrices.p.allFinite() || !matrices.q.allFinite())
    throw not_solved("the integrals of products of the wave functions are not finite");
  if (matrices.p.llt().info() != Eigen::Success)
    throw not_solved("the squares of wave functions have no positive integrals");
  Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(-matrices.q, matrices.p);
  if (solver.info() != Eigen::Success) throw not_solved("the search for the energies does not end");
  if (!solver.eigenvalues().allFinite() || !solver.eigenvectors().allFinite())
    throw not_solved("energies or wave functions are not finite");
  return solver;
}

}  // namespace

SchroedingerMatrices schroedinger_matrices(const SchroedingerProblem& problem) {
  const int last = 2 * problem.intervals;
  MatrixXd p = MatrixXd::Zero(last + 2, last + 2), q = p;
  for (int i = 0; i < problem.intervals; ++i) add_interval(problem, i, p, q);
  if (problem.decay_below) add_tail(problem, tail_below(problem), 0, p, q);
  if (problem.decay_above) add_tail(problem, tail_above(problem), last, p, q);
  const MatrixXd nodal = nodal_of_unknowns(problem);
  return {nodal.transpose() * p * nodal, nodal.transpose() * q * nodal, nodal};
}

/// The unknowns' functions have no kinks, and those with walls vanish there: so Q is symmetric.
StationaryStates::StationaryStates(const SchroedingerProblem& problem, int count)
    : problem_(problem) {
  if (problem.intervals < 1 || count < 1 || count > 2 * problem.intervals)
    throw std::domain_error("n intervals have 2 n states");
  const SchroedingerMatrices matrices = schroedinger_matrices(problem);
  const auto solver = solved(matrices);
  energies_ = solver.eigenvalues().head(count);
  nodal_ = matrices.nodal * solver.eigenvectors().leftCols(count);
  for (int state = 0; state < count; ++state) {
    auto column = nodal_.col(state);
    const auto first = std::ranges::find_if(column, [&](double number) {
      return std::abs(number) > 1e-3 * column.lpNorm<Eigen::Infinity>();
    });
    if (*first < 0) column *= -1;
  }
}

double StationaryStates::wave_function(int state, double x) const {
  const auto column = nodal_.col(state);
  if (x < problem_.lower)
    return problem_.decay_below
               ? column[0] * tail_below(problem_).function(problem_.lower - x).value
               : 0;
  if (x > problem_.upper)
    return problem_.decay_above ? column[2 * problem_.intervals] *
                                      tail_above(problem_).function(x - problem_.upper).value
                                : 0;
  const double along = (x - problem_.lower) / (problem_.upper - problem_.lower);
  const int i = std::min(static_cast<int>(along * problem_.intervals), problem_.intervals - 1);
  const auto functions = interval(problem_, i).functions(x);
  double sum = 0;
  for (int k = 0; k < 4; ++k)
    sum += column[2 * i + k] * functions[static_cast<std::size_t>(k)].value;
  return sum;
}

}  // namespace mote
