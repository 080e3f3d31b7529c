#include "mote/solvers/system_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mote/particles/failure.hpp"
#include "mote/solvers/linear_solver.hpp"

namespace mote {

void require_tolerance(double tolerance) {
  if (tolerance >= LinearSolver::least_tolerance) return;
  throw InputError(fmt::format(
      "a tolerance of {:g} is beyond double precision: linear systems are solved to {:g} at best",
      tolerance, LinearSolver::least_tolerance));
}

void require_sizes(const SparseMatrix& matrix, std::span<const double> right_side,
                   std::span<const double> solution) {
  const auto rows = static_cast<std::size_t>(matrix.rows());
  if (matrix.rows() == matrix.cols() && right_side.size() == rows && solution.size() == rows)
    return;
  throw std::invalid_argument(fmt::format("a matrix of {} x {} does not fit {} and {} values",
                                          matrix.rows(), matrix.cols(), right_side.size(),
                                          solution.size()));
}

void require_finite(const std::string& name, const char* what, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw NumericalFailure(
          fmt::format("{} cannot be solved: row {} of the {} is {}", name, i, what, values[i]),
          {static_cast<Index>(i)}, "a breakdown before this system was set up");
}

namespace {

struct RowSums {
  double diagonal = 0, magnitudes = 0;
  bool usable() const { return diagonal > 0 && std::isfinite(magnitudes); }
};

RowSums sums_of(const SparseMatrix& matrix, Index i) {
  const auto columns = row_columns(matrix, i);
  const auto values = row_values(matrix, i);
  RowSums sums;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sums.magnitudes += std::abs(values[k]);
    if (columns[k] == i) sums.diagonal = values[k];
  }
  return sums;
}

}  // namespace

void require_positive_diagonal(const std::string& name, const SparseMatrix& matrix) {
  const Index rows = static_cast<Index>(matrix.rows());
  Index first = rows;
#pragma omp parallel for schedule(static) reduction(min : first) if (parallel_from <= rows)
  for (Index i = 0; i < rows; ++i)
    if (!sums_of(matrix, i).usable()) first = std::min(first, i);
  if (first == rows) return;
  const RowSums sums = sums_of(matrix, first);
  throw NumericalFailure(fmt::format("{} cannot be solved: the diagonal of row {} is {:g}, and its "
                                     "magnitudes add up to {:g}",
                                     name, first, sums.diagonal, sums.magnitudes),
                         {first}, "an unknown without neighbours, or a breakdown before");
}

}  // namespace mote
