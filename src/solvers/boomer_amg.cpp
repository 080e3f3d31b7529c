#include "mote/solvers/boomer_amg.hpp"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>

#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "mote/particles/failure.hpp"
#include "mote/solvers/mpi_session.hpp"
#include "mote/solvers/strong_part.hpp"

namespace mote {
namespace {

static_assert(std::is_same_v<HYPRE_Int, Index> && std::is_same_v<HYPRE_BigInt, Index> &&
                  std::is_same_v<HYPRE_Complex, double>,
              "hypre must be built with 32-bit numbers and real doubles");

/// Throws what hypre has to say about its calls since the last time.
void require_success(const char* attempt) {
  const HYPRE_Int error = HYPRE_GetError();
  if (error == 0) return;
  HYPRE_ClearAllErrors();
  char description[1024] = "";
  HYPRE_DescribeError(error, description);
  throw NumericalFailure(std::string("hypre could not ") + attempt + ": " + description, {},
                         "a matrix far from those of a Laplacian");
}

/// A vector of hypre's.
class Vector {
 public:
  explicit Vector(Index size) : size_(size) {
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, size - 1, &handle_);
    HYPRE_IJVectorSetObjectType(handle_, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(handle_);
    HYPRE_IJVectorAssemble(handle_);
  }
  Vector(const Vector&) = delete;
  Vector& operator=(const Vector&) = delete;
  ~Vector() { HYPRE_IJVectorDestroy(handle_); }

  void assign(const Eigen::VectorXd& values) {
    HYPRE_IJVectorSetValues(handle_, size_, nullptr, values.data());
  }
  void write_to(Eigen::VectorXd& values) const {
    values.resize(size_);
    HYPRE_IJVectorGetValues(handle_, size_, nullptr, values.data());
  }
  HYPRE_ParVector get() const {
    void* object = nullptr;
    HYPRE_IJVectorGetObject(handle_, &object);
    return static_cast<HYPRE_ParVector>(object);
  }

 private:
  Index size_;
  HYPRE_IJVector handle_ = nullptr;
};

/// A copy of a matrix in hypre's form.
class Matrix {
 public:
  explicit Matrix(const SparseMatrix& matrix) {
    const Index rows = static_cast<Index>(matrix.rows());
    std::vector<Index> sizes(static_cast<std::size_t>(rows)), none(sizes.size()),
        numbers(sizes.size());
    for (Index i = 0; i < rows; ++i) sizes[i] = static_cast<Index>(row_columns(matrix, i).size());
    std::iota(numbers.begin(), numbers.end(), 0);
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, rows - 1, 0, rows - 1, &handle_);
    HYPRE_IJMatrixSetObjectType(handle_, HYPRE_PARCSR);
    HYPRE_IJMatrixSetDiagOffdSizes(handle_, sizes.data(), none.data());
    HYPRE_IJMatrixInitialize(handle_);
    HYPRE_IJMatrixSetValues(handle_, rows, sizes.data(), numbers.data(), matrix.innerIndexPtr(),
                            matrix.valuePtr());
    HYPRE_IJMatrixAssemble(handle_);
  }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { HYPRE_IJMatrixDestroy(handle_); }

  HYPRE_ParCSRMatrix get() const {
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(handle_, &object);
    return static_cast<HYPRE_ParCSRMatrix>(object);
  }

 private:
  HYPRE_IJMatrix handle_ = nullptr;
};

constexpr HYPRE_Int down = 1, up = 2;  // parts of a cycle

/// Forward sweeps on the way down and backward ones on the way up make a symmetric cycle. On one
/// process the l1 norms add nothing to the diagonal, and this is Gauss-Seidel.
void choose_smoothers(HYPRE_Solver amg) {
  constexpr HYPRE_Int forward = 13, backward = 14;
  HYPRE_BoomerAMGSetCycleRelaxType(amg, forward, down);
  HYPRE_BoomerAMGSetCycleRelaxType(amg, backward, up);
}

/// What the multigrid is made for: the weights of particle methods fall fast with distance, and
/// without weak entries cycles cost half as much and are as good.
///
/// A little more on the diagonal makes it regular, also where the matrix is singular, or a few
/// unknowns hang together with the others by weak entries alone: the elimination on the coarsest
/// level would divide by zero otherwise. Relaxation there instead does not converge for every
/// matrix that is not symmetric.
SparseMatrix regular_strong_part(const SparseMatrix& matrix) {
  constexpr double weak = 0.1, little = 1e-6;
  SparseMatrix part = strong_part(matrix, weak);
  for (Index i = 0; i < part.rows(); ++i) part.coeffRef(i, i) *= 1 + little;
  return part;
}

/// For matrices of 20 to 60 entries a row: coarsening by PMIS (De Sterck, Yang, Heys, SIAM J.
/// Matrix Anal. Appl. 27 (2006) 1019), interpolation `extended+e` by products of matrices (Li,
/// Sjogreen, Yang, SIAM J. Sci. Comput. 43 (2021)) with at most four entries a row. One level of
/// aggressive coarsening would shorten the set-up by a third and double the iterations; together
/// that is slower in 2D and the same in 3D.
void choose_levels(HYPRE_Solver amg) {
  constexpr HYPRE_Int pmis = 8, extended_e = 18;
  HYPRE_BoomerAMGSetCoarsenType(amg, pmis);
  HYPRE_BoomerAMGSetInterpType(amg, extended_e);
  HYPRE_BoomerAMGSetPMaxElmts(amg, 4);
  HYPRE_BoomerAMGSetAggNumLevels(amg, 0);
  HYPRE_BoomerAMGSetStrongThreshold(amg, 0.25);
}

/// One cycle from zero, whatever remains of the residual.
void choose_one_cycle(HYPRE_Solver amg) {
  HYPRE_BoomerAMGSetMaxIter(amg, 1);
  HYPRE_BoomerAMGSetTol(amg, 0);
  HYPRE_BoomerAMGSetPrintLevel(amg, 0);
}

}  // namespace

/// What hypre keeps of a matrix.
struct BoomerAmg::Levels {
  explicit Levels(const SparseMatrix& values)
      : matrix(regular_strong_part(values)),
        residual(static_cast<Index>(values.rows())),
        correction(static_cast<Index>(values.rows())) {
    HYPRE_BoomerAMGCreate(&amg);
    choose_levels(amg);
    choose_smoothers(amg);
    choose_one_cycle(amg);
    HYPRE_BoomerAMGSetup(amg, matrix.get(), residual.get(), correction.get());
  }
  Levels(const Levels&) = delete;
  Levels& operator=(const Levels&) = delete;
  ~Levels() { HYPRE_BoomerAMGDestroy(amg); }

  Matrix matrix;
  Vector residual, correction;
  HYPRE_Solver amg = nullptr;
};

BoomerAmg::BoomerAmg() { begin_mpi(); }
BoomerAmg::~BoomerAmg() = default;

void BoomerAmg::prepare(const SparseMatrix& matrix) {
  levels_.reset();  // before the new ones, to save memory
  levels_ = std::make_unique<Levels>(matrix);
  require_success("prepare its multigrid");
}

void BoomerAmg::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) {
  levels_->residual.assign(residual);
  HYPRE_ParVectorSetConstantValues(levels_->correction.get(), 0);
  HYPRE_BoomerAMGSolve(levels_->amg, levels_->matrix.get(), levels_->residual.get(),
                       levels_->correction.get());
  require_success("apply its multigrid");
  levels_->correction.write_to(correction);
}

}  // namespace mote
