#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/particles/extension.hpp"

namespace mote {

/// The receiver with the largest sum of |l_ij| over its neighbours, and that sum [1/length^2].
struct LargestRowSum {
  Index receiver = 0;
  double sum = 0;

  /// Takes another sum if it is larger; one that is no number is the largest.
  void take(Index other, double other_sum);
};

/// That of a prepared operator, without held end particles. By Gershgorin's bound an explicit step
/// of du/dt = nu lap u does not grow up to 1/(nu times the sum) where no weight is negative; with
/// three points that is the known dx^2/(2 nu).
LargestRowSum largest_row_sum(const DifferentialOperator<1>& op, const NeighbourLists& lists,
                              LineEnds ends);

/// Diffusion du/dt = nu lap u of a velocity on a line, over a time in which the points stand still.
/// The Laplacian is the operator's own, as a sparse matrix in which the cells beyond the ends are
/// the particles whose values they have. Held end particles keep theirs.
class LineDiffusion {
 public:
  /// Takes the rows of a prepared operator, and forgets the former ones.
  void assemble(const DifferentialOperator<1>& op, const NeighbourLists& lists,
                const LineExtension& extension);

  /// Over `amount` = nu times the time, by the L-stable method of order 2 with two implicit stages
  /// (SDIRK2, Alexander 1977): stable at any amount. Throws NumericalFailure if the equations have
  /// no solution.
  void advance_implicitly(double amount, std::span<double> values);

  /// The same in sub-steps of Heun's method, order 2, none longer than Gershgorin's bound. Returns
  /// their number. Throws NumericalFailure if there are more than a million.
  std::int64_t advance_in_substeps(double amount, std::span<double> values) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  void factorise(double amount);

  Matrix laplacian_;
  LargestRowSum row_sum_;
  // Particles on a line are numbered along it: the natural order fills in least.
  Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>> solver_;
  std::optional<double> factorised_amount_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace mote
