#pragma once

#include <memory>
#include <string_view>

#include "mote/solvers/preconditioner.hpp"

namespace mote {

/// One V-cycle of hypre's algebraic multigrid, BoomerAMG: Henson, Yang, Appl. Numer. Math. 41
/// (2002) 155. Runs in this process on one thread.
class BoomerAmg final : public Preconditioner {
 public:
  static constexpr std::string_view name = "hypre";
  static constexpr std::string_view summary =
      "Krylov iterations preconditioned by algebraic multigrid; their number hardly grows";

  BoomerAmg();
  ~BoomerAmg() override;

  /// Throws NumericalFailure if hypre finds no coarse levels for the matrix.
  void prepare(const SparseMatrix& matrix) override;
  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override;

 private:
  struct Levels;
  std::unique_ptr<Levels> levels_;
};

}  // namespace mote
