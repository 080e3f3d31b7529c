#include "mote/solvers/sparse_matrix.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// Entries of row i: receivers among its neighbours, and the diagonal.
Index entries(const NeighbourLists& lists, Index i) {
  const auto columns =
      std::ranges::count_if(lists[i], [&](Index j) { return j < lists.receivers(); });
  return static_cast<Index>(columns) + 1;
}

void write_columns(const NeighbourLists& lists, Index i, std::span<Index> columns) {
  columns.front() = i;
  std::ranges::copy_if(lists[i], columns.begin() + 1,
                       [&](Index j) { return j < lists.receivers(); });
  std::ranges::sort(columns);
}

/// Four sums, so that additions need not wait for each other.
double row_times(std::span<const Index> columns, std::span<const double> values, const double* x) {
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> sum{};
  const std::size_t whole = values.size() / lanes * lanes;
  for (std::size_t k = 0; k < whole; k += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      sum[lane] += values[k + lane] * x[columns[k + lane]];
  for (std::size_t k = whole; k < values.size(); ++k) sum[k - whole] += values[k] * x[columns[k]];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

SparseMatrix matrix_of_zeros(const NeighbourLists& lists) {
  const Index rows = lists.receivers();
  if (lists.pairs() + rows > std::numeric_limits<Index>::max())
    throw InputError("a matrix for so many neighbours has more entries than its numbers can count");
  SparseMatrix matrix(rows, rows);
  Index* const start = matrix.outerIndexPtr();
  start[0] = 0;
#pragma omp parallel for schedule(static) if (parallel_from <= rows)
  for (Index i = 0; i < rows; ++i) start[i + 1] = entries(lists, i);
  std::partial_sum(start, start + rows + 1, start);
  matrix.resizeNonZeros(start[rows]);
  std::fill_n(matrix.valuePtr(), start[rows], 0.0);
#pragma omp parallel for schedule(static) if (parallel_from <= rows)
  for (Index i = 0; i < rows; ++i)
    write_columns(
        lists, i,
        {matrix.innerIndexPtr() + start[i], static_cast<std::size_t>(start[i + 1] - start[i])});
  return matrix;
}

void multiply(const SparseMatrix& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& product) {
  product.resize(matrix.rows());
#pragma omp parallel for schedule(static) if (parallel_from <= matrix.rows())
  for (Index i = 0; i < matrix.rows(); ++i)
    product[i] = row_times(row_columns(matrix, i), row_values(matrix, i), x.data());
}

}  // namespace mote
