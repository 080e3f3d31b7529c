#include "mote/sums/harmonic_axis.hpp"

#include <utility>

#include "mote/sums/harmonic_tables.hpp"

namespace mote {
namespace {

/// Some outputs of an order, of degree l and above. Coefficients begin at the cosine of the lowest
/// degree n = order, whose sine is that far behind; from degree n to n + 1 it is 2n + 1.
template <int rows, bool sines>
[[gnu::always_inline]] inline void inward_rows(const double* matrix, std::size_t order,
                                               std::size_t degrees, const Lanes* in, std::size_t l,
                                               Lanes* out) {
  Lanes even[rows], odd[rows];
  for (int r = 0; r < rows; ++r) {
    even[r] = matrix[r] * in[0];
    if constexpr (sines) odd[r] = matrix[r] * in[order];
  }
  for (std::size_t n = order + 1; n < order + degrees; ++n) {
    in += 2 * n - 1;
    matrix += HarmonicTables::row_length(static_cast<int>(order));
    const Lanes c = in[0], s = in[sines ? n : 0];
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) {
      const Lanes factor = matrix[r];
      even[r] += factor * c;
      if constexpr (sines) odd[r] += factor * s;
    }
  }
  for (int r = 0; r < rows; ++r, ++l) {
    out[l * l + order] = even[r];
    if constexpr (sines) out[l * l + l + order] = odd[r];
  }
}

template <bool sines, int... rows>
[[gnu::always_inline]] inline void inward_some_rows(std::integer_sequence<int, rows...>,
                                                    std::size_t count, const double* matrix,
                                                    std::size_t order, std::size_t degrees,
                                                    const Lanes* in, std::size_t l, Lanes* out) {
  ((count == rows + 1 ? inward_rows<rows + 1, sines>(matrix, order, degrees, in, l, out) : void()),
   ...);
}

template <bool sines>
void inward_order(const double* matrix, std::size_t order, std::size_t degrees, const Lanes* in,
                  Lanes* __restrict out) {
  const Lanes* first = in + order * order + order;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < degrees; i += rows) {
    const std::size_t left = degrees - i;
    rows = left > 8 ? 6 : left > 6 ? 4 : left;
    inward_some_rows<sines>(std::make_integer_sequence<int, 6>(), rows, matrix + i, order, degrees,
                            first, order + i, out);
  }
}

}  // namespace

void turn_inward(int degree, const Lanes* in, Lanes* out) {
  const HarmonicTables& tables = harmonic_tables();
  inward_order<false>(tables.outward_to_inward(0), 0, degrees_of(degree, 0), in, out);
  for (int m = 1; m <= degree; ++m)
    inward_order<true>(tables.outward_to_inward(m), static_cast<std::size_t>(m),
                       degrees_of(degree, m), in, out);
}

void move_multipole(int degree, const Lanes* powers, const Lanes* in, Lanes* __restrict out) {
  for (int m = 0; m <= degree; ++m) {
    const double* matrix = harmonic_tables().change_of_centre(m);
    for (int l = m; l <= degree; ++l) {
      Lanes even = 0, odd = 0;
      for (int n = m; n <= l; ++n) {
        const Lanes factor =
            matrix[static_cast<std::size_t>(n - m) * HarmonicTables::row_length(m) +
                   static_cast<std::size_t>(l - m)] *
            powers[l - n];
        even += factor * in[cosine_place(n, m)];
        odd += factor * in[sine_place(n, m)];
      }
      out[cosine_place(l, m)] = even;
      if (m > 0) out[sine_place(l, m)] = odd;
    }
  }
}

void move_local(int degree, const Lanes* powers, const Lanes* in, Lanes* __restrict out) {
  for (int m = 0; m <= degree; ++m)
    for (int n = m; n <= degree; ++n) {
      const double* row = harmonic_tables().change_of_centre(m) +
                          static_cast<std::size_t>(n - m) * HarmonicTables::row_length(m);
      Lanes even = 0, odd = 0;
      for (int l = n; l <= degree; ++l) {
        const Lanes factor = row[l - m] * powers[l - n];
        even += factor * in[cosine_place(l, m)];
        odd += factor * in[sine_place(l, m)];
      }
      out[cosine_place(n, m)] = even;
      if (m > 0) out[sine_place(n, m)] = odd;
    }
}

}  // namespace mote
