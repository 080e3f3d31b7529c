#pragma once

#include "mote/solvers/sparse_matrix.hpp"

namespace mote {

/// A matrix without its weak entries, which are added to the diagonals of their rows, so that it
/// does the same to what varies little. An entry is weak if its square is below
/// `threshold` squared times the strongest entries beside the diagonal of its row and of its
/// column's row; of a symmetric matrix the strong part is symmetric.
SparseMatrix strong_part(const SparseMatrix& matrix, double threshold);

}  // namespace mote
