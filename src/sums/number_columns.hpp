#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mote/sums/pair_loop.hpp"

namespace mote {

/// A table in columns, each with room for the pair loop to read beyond its end.
class NumberColumns {
 public:
  /// `columns` numbers a row, one row after the other, times `scale`.
  void take(std::span<const double> rows, int columns, double scale = 1) {
    clear(rows.size() / columns, columns);
    for (int c = 0; c < columns; ++c)
      for (std::size_t i = 0; i < rows_; ++i) column(c)[i] = scale * rows[i * columns + c];
  }

  /// Zeros.
  void clear(std::size_t rows, int columns) {
    rows_ = rows;
    numbers_.assign(columns * stride(), 0.0);
  }

  /// `columns` of them from `first` on, one row after the other.
  void give(int first, int columns, std::span<double> rows) const {
    for (std::size_t i = 0; i < rows_; ++i)
      for (int c = 0; c < columns; ++c) rows[i * columns + c] = column(first + c)[i];
  }

  std::size_t rows() const { return rows_; }
  double* column(int c) { return numbers_.data() + c * stride(); }
  const double* column(int c) const { return numbers_.data() + c * stride(); }

 private:
  std::size_t stride() const { return packs_for(rows_) * lane_count + column_padding; }

  std::size_t rows_ = 0;
  std::vector<double> numbers_;
};

}  // namespace mote
