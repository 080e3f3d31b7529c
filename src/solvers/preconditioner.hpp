#pragma once

#include <Eigen/Core>
#include <string_view>

#include "mote/solvers/sparse_matrix.hpp"

namespace mote {

/// A cheap approximation of a matrix's inverse, linear, and symmetric where the matrix is.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;

  /// Takes over a matrix with a positive diagonal, which may be singular.
  virtual void prepare(const SparseMatrix& matrix) = 0;

  /// Whether preparing costs more than a few iterations.
  virtual bool is_worth_keeping() const { return true; }

  /// Writes about inverse(matrix) * residual.
  virtual void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) = 0;
};

/// Divides by the diagonal.
class DiagonalPreconditioner final : public Preconditioner {
 public:
  static constexpr std::string_view name = "eigen";
  static constexpr std::string_view summary =
      "Krylov iterations preconditioned by the diagonal; their number grows with that of points "
      "across";

  void prepare(const SparseMatrix& matrix) override {
    inverse_diagonal_ = matrix.diagonal().cwiseInverse();
  }

  bool is_worth_keeping() const override { return false; }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override {
    correction = inverse_diagonal_.cwiseProduct(residual);
  }

 private:
  Eigen::VectorXd inverse_diagonal_;
};

}  // namespace mote
