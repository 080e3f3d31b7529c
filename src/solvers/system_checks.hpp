#pragma once

#include <span>
#include <string>

#include "mote/solvers/sparse_matrix.hpp"

namespace mote {

/// Throws InputError for a tolerance that double precision cannot meet.
void require_tolerance(double tolerance);

/// Throws std::invalid_argument unless the matrix is square and both vectors fit it.
void require_sizes(const SparseMatrix& matrix, std::span<const double> right_side,
                   std::span<const double> solution);

/// Throws NumericalFailure with the first row where `values`, the `what` of the system `name`, is
/// not finite.
void require_finite(const std::string& name, const char* what, std::span<const double> values);

/// Throws NumericalFailure with the first row that has a number that is not finite, or no positive
/// diagonal.
void require_positive_diagonal(const std::string& name, const SparseMatrix& matrix);

}  // namespace mote
