#include "mote/solvers/strong_part.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace mote {
namespace {

/// The entries of a matrix that stay.
class Strong {
 public:
  Strong(const SparseMatrix& matrix, double threshold)
      : matrix_(matrix), strongest_(static_cast<std::size_t>(matrix.rows())) {
#pragma omp parallel for schedule(static) if (parallel_from <= rows())
    for (Index i = 0; i < rows(); ++i) {
      const auto columns = row_columns(matrix_, i);
      const auto values = row_values(matrix_, i);
      double most = 0;
      for (std::size_t k = 0; k < values.size(); ++k)
        if (columns[k] != i) most = std::max(most, std::abs(values[k]));
      strongest_[static_cast<std::size_t>(i)] = threshold * most;
    }
  }

  Index rows() const { return static_cast<Index>(matrix_.rows()); }

  bool operator()(Index i, Index j, double value) const {
    return i == j || value * value > strongest_[static_cast<std::size_t>(i)] *
                                         strongest_[static_cast<std::size_t>(j)];
  }

 private:
  const SparseMatrix& matrix_;
  std::vector<double> strongest_;
};

/// Copies the strong entries of row i and adds the others to its diagonal.
void copy_row(const SparseMatrix& from, const Strong& strong, Index i, SparseMatrix& to) {
  const auto columns = row_columns(from, i);
  const auto values = row_values(from, i);
  Index at = to.outerIndexPtr()[i], diagonal = at;
  double weak = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!strong(i, columns[k], values[k])) {
      weak += values[k];
      continue;
    }
    if (columns[k] == i) diagonal = at;
    to.innerIndexPtr()[at] = columns[k];
    to.valuePtr()[at++] = values[k];
  }
  to.valuePtr()[diagonal] += weak;
}

}  // namespace

SparseMatrix strong_part(const SparseMatrix& matrix, double threshold) {
  const Strong strong(matrix, threshold);
  SparseMatrix part(matrix.rows(), matrix.cols());
  Index* const start = part.outerIndexPtr();
  start[0] = 0;
#pragma omp parallel for schedule(static) if (parallel_from <= strong.rows())
  for (Index i = 0; i < strong.rows(); ++i) {
    const auto columns = row_columns(matrix, i);
    const auto values = row_values(matrix, i);
    start[i + 1] = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      start[i + 1] += strong(i, columns[k], values[k]) ? 1 : 0;
  }
  std::partial_sum(start, start + strong.rows() + 1, start);
  part.resizeNonZeros(start[strong.rows()]);
#pragma omp parallel for schedule(static) if (parallel_from <= strong.rows())
  for (Index i = 0; i < strong.rows(); ++i) copy_row(matrix, strong, i, part);
  return part;
}

}  // namespace mote
