#include "mote/solvers/sparse_matrix.hpp"

#include <algorithm>
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

}  // namespace mote
