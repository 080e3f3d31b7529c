#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mote/particles/parallel.hpp"
#include "mote/sums/pair_loop.hpp"

namespace mote {

/// A table in columns, each with room for the pair loop to read beyond its end.
class NumberColumns {
 public:
  /// `columns` numbers a row, one row after the other, times `scale`; row i becomes that of number
  /// order[i], or stays where it is if there is no order.
  void take(std::span<const double> rows, int columns, double scale = 1,
            std::span<const Index> order = {}) {
    clear(rows.size() / static_cast<std::size_t>(columns), columns);
    const auto width = static_cast<std::size_t>(columns);
#pragma omp parallel for schedule(static) if (rows_ >= parallel_from)
    for (std::size_t i = 0; i < rows_; ++i)
      for (int c = 0; c < columns; ++c)
        column(c)[i] = scale * rows[place(order, i) * width + static_cast<std::size_t>(c)];
  }

  /// Zeros.
  void clear(std::size_t rows, int columns) {
    rows_ = rows;
    numbers_.assign(static_cast<std::size_t>(columns) * stride(), 0.0);
  }

  /// `columns` of them from `first` on, one row after the other, in the order that was taken.
  void give(int first, int columns, std::span<double> rows,
            std::span<const Index> order = {}) const {
    const auto width = static_cast<std::size_t>(columns);
#pragma omp parallel for schedule(static) if (rows_ >= parallel_from)
    for (std::size_t i = 0; i < rows_; ++i)
      for (int c = 0; c < columns; ++c)
        rows[place(order, i) * width + static_cast<std::size_t>(c)] = column(first + c)[i];
  }

  std::size_t rows() const { return rows_; }
  double* column(int c) { return numbers_.data() + static_cast<std::size_t>(c) * stride(); }
  const double* column(int c) const {
    return numbers_.data() + static_cast<std::size_t>(c) * stride();
  }

 private:
  static std::size_t place(std::span<const Index> order, std::size_t i) {
    return order.empty() ? i : static_cast<std::size_t>(order[i]);
  }
  std::size_t stride() const { return packs_for(rows_) * lane_count + column_padding; }

  std::size_t rows_ = 0;
  std::vector<double> numbers_;
};

}  // namespace mote
