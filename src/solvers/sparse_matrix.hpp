#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <span>

#include "mote/neighbours/lists.hpp"

namespace mote {

/// A matrix in compressed rows, columns ascending in each. Its pattern can stay while its values
/// change.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

/// A square matrix of zeros with one row for every receiver, an entry on its diagonal, and one
/// wherever a receiver is the neighbour of another. Neighbours that are no receivers have no
/// column: what they contribute is known, and belongs to the diagonal and the right side.
SparseMatrix matrix_of_zeros(const NeighbourLists& lists);

/// Columns of the entries in row i, ascending.
inline std::span<const Index> row_columns(const SparseMatrix& matrix, Index i) {
  const Index* const start = matrix.outerIndexPtr();
  return {matrix.innerIndexPtr() + start[i], static_cast<std::size_t>(start[i + 1] - start[i])};
}

/// Values of the entries in row i, in the order of `row_columns`.
inline std::span<const double> row_values(const SparseMatrix& matrix, Index i) {
  const Index* const start = matrix.outerIndexPtr();
  return {matrix.valuePtr() + start[i], static_cast<std::size_t>(start[i + 1] - start[i])};
}

/// The same, to be written.
inline std::span<double> row_values(SparseMatrix& matrix, Index i) {
  const Index* const start = matrix.outerIndexPtr();
  return {matrix.valuePtr() + start[i], static_cast<std::size_t>(start[i + 1] - start[i])};
}

/// Writes matrix * x, of which every number has the same bits for any number of threads.
void multiply(const SparseMatrix& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& product);

}  // namespace mote
