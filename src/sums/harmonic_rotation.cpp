#include "mote/sums/harmonic_rotation.hpp"

#include <utility>

namespace mote {
namespace {

namespace simd = std::experimental;

/// Degrees that have code of their own, without loops. More would save nothing.
constexpr int unrolled_degrees = 6;

using DegreeLanes = std::array<Lanes, 2 * highest_degree + 1>;

/// out_m = sum_k matrix_km in_k for `rows` of the outputs; every second place is meant.
template <int rows>
[[gnu::always_inline]] inline void product(const double* matrix, int row_length, int inputs,
                                           const Lanes* in, Lanes* __restrict out) {
  Lanes sums[rows];
#pragma GCC unroll 32
  for (int m = 0; m < rows; ++m) sums[m] = matrix[m] * in[0];
#pragma GCC unroll 32
  for (int k = 1; k < inputs; ++k) {
    const Lanes value = in[2 * k];
    const double* row = matrix + k * row_length;
#pragma GCC unroll 32
    for (int m = 0; m < rows; ++m) sums[m] += row[m] * value;
  }
#pragma GCC unroll 32
  for (int m = 0; m < rows; ++m) out[2 * m] = sums[m];
}

template <int degree, int number>
[[gnu::always_inline]] inline void exchange_part(const double*& matrix, const Lanes* in,
                                                 Lanes* out) {
  constexpr ExchangeBlock block = exchange_block(degree, number);
  if constexpr (block.inputs > 0 && block.outputs > 0)
    product<block.outputs>(matrix, block.outputs, block.inputs, in + block.first_input,
                           out + block.first_output);
  matrix += block.inputs * block.outputs;
}

template <int degree>
[[gnu::always_inline]] inline void exchange(const double* matrix, const Lanes* in,
                                            Lanes* __restrict out) {
  exchange_part<degree, 0>(matrix, in, out);
  exchange_part<degree, 1>(matrix, in, out);
  exchange_part<degree, 2>(matrix, in, out);
  exchange_part<degree, 3>(matrix, in, out);
}

template <int... rows>
[[gnu::always_inline]] inline void some_rows(std::integer_sequence<int, rows...>, int count,
                                             const double* matrix, const ExchangeBlock& block,
                                             const Lanes* in, Lanes* out) {
  ((count == rows + 1 ? product<rows + 1>(matrix, block.outputs, block.inputs, in, out) : void()),
   ...);
}

void exchange_by_loops(int degree, const double* matrix, const Lanes* in, Lanes* __restrict out) {
  for (int number = 0; number < 4; ++number) {
    const ExchangeBlock block = exchange_block(degree, number);
    const Lanes* from = in + block.first_input;
    Lanes* to = out + block.first_output;
    int rows = 0;
    for (int m = 0; m < block.outputs; m += rows) {
      const int left = block.outputs - m;
      rows = left >= 16 || left == 8 ? 8 : left > 8 ? left / 2 : left;
      some_rows(std::make_integer_sequence<int, 8>(), rows, matrix + m, block, from, to + 2 * m);
    }
    matrix += block.inputs * block.outputs;
  }
}

/// The axes turned about z by an angle.
[[gnu::always_inline]] inline void turn(int degree, const Phases& phases, const Lanes* in,
                                        Lanes* __restrict out) {
  out[0] = in[0];
#pragma GCC unroll 32
  for (int m = 1; m <= degree; ++m) {
    const Lanes c = phases.cosine(m), s = phases.sine(m), even = in[m], odd = in[degree + m];
    out[m] = c * even + s * odd;
    out[degree + m] = c * odd - s * even;
  }
}

[[gnu::always_inline]] inline void turn_back(int degree, const Phases& phases, const Lanes* in,
                                             Lanes* __restrict out) {
  out[0] = in[0];
#pragma GCC unroll 32
  for (int m = 1; m <= degree; ++m) {
    const Lanes c = phases.cosine(m), s = phases.sine(m), even = in[m], odd = in[degree + m];
    out[m] = c * even - s * odd;
    out[degree + m] = c * odd + s * even;
  }
}

using Turn = void (*)(const double* matrix, const AxisTurn& axis, const Lanes* in, Lanes* out);
using TurnBack = void (*)(const double* matrix, const AxisTurn& axis, const Lanes& factor,
                          const Lanes* in, Lanes* sums);

template <int degree>
void to_axis(const double* matrix, const AxisTurn& axis, const Lanes* in, Lanes* __restrict out) {
  Lanes first[2 * degree + 1], second[2 * degree + 1];
  turn(degree, axis.azimuth, in, first);
  exchange<degree>(matrix, first, second);
  turn(degree, axis.polar, second, first);
  exchange<degree>(matrix, first, out);
}

template <int degree>
void from_axis(const double* matrix, const AxisTurn& axis, const Lanes& factor, const Lanes* in,
               Lanes* __restrict sums) {
  Lanes first[2 * degree + 1], second[2 * degree + 1];
  exchange<degree>(matrix, in, first);
  turn_back(degree, axis.polar, first, second);
  exchange<degree>(matrix, second, first);
  turn_back(degree, axis.azimuth, first, second);
#pragma GCC unroll 64
  for (int i = 0; i <= 2 * degree; ++i) sums[i] += factor * second[i];
}

template <int... degrees>
constexpr std::array<Turn, sizeof...(degrees)> turns_to_axis(
    std::integer_sequence<int, degrees...>) {
  return {&to_axis<degrees>...};
}
template <int... degrees>
constexpr std::array<TurnBack, sizeof...(degrees)> turns_from_axis(
    std::integer_sequence<int, degrees...>) {
  return {&from_axis<degrees>...};
}
using UnrolledDegrees = std::make_integer_sequence<int, unrolled_degrees + 1>;
constexpr auto unrolled_to_axis = turns_to_axis(UnrolledDegrees());
constexpr auto unrolled_from_axis = turns_from_axis(UnrolledDegrees());

}  // namespace

void Phases::prepare(int degree, const Lanes& cosine, const Lanes& sine) {
  cosine_[0] = 1;
  sine_[0] = 0;
  for (std::size_t m = 1; m <= static_cast<std::size_t>(degree); ++m) {
    cosine_[m] = cosine_[m - 1] * cosine - sine_[m - 1] * sine;
    sine_[m] = sine_[m - 1] * cosine + cosine_[m - 1] * sine;
  }
}

void AxisTurn::prepare(int degree, const std::array<Lanes, 3>& displacement) {
  // Squares of lengths near the ends of the range of numbers would leave it.
  Lanes scale =
      simd::max(simd::max(abs(displacement[0]), abs(displacement[1])), abs(displacement[2]));
  where(scale == 0, scale) = 1;
  const Lanes x = displacement[0] / scale, y = displacement[1] / scale;
  Lanes z = displacement[2] / scale;
  const Lanes from_axis_squared = x * x + y * y;
  // So near the axis that the root of the square would have lost digits, any azimuth is right.
  const auto on_axis = from_axis_squared < 1e-200;
  const auto nowhere = on_axis && z == 0;
  Lanes from_axis = sqrt(from_axis_squared);
  where(nowhere, z) = 1;
  Lanes cosine = y / from_axis, sine = -x / from_axis;
  where(on_axis, cosine) = 1;
  where(on_axis, sine) = 0;
  azimuth.prepare(degree, cosine, sine);
  const Lanes length = sqrt(from_axis_squared + z * z);
  polar.prepare(degree, z / length, from_axis / length);
  distance = length * scale;
  where(nowhere, distance) = 0;
}

void turn_to_axis(int degree, const AxisTurn& axis, const Lanes* coefficients, Lanes* turned) {
  const double* matrix = axis.tables.exchange(degree);
  if (degree <= unrolled_degrees)
    return unrolled_to_axis[static_cast<std::size_t>(degree)](matrix, axis, coefficients, turned);
  DegreeLanes first, second;
  turn(degree, axis.azimuth, coefficients, first.data());
  exchange_by_loops(degree, matrix, first.data(), second.data());
  turn(degree, axis.polar, second.data(), first.data());
  exchange_by_loops(degree, matrix, first.data(), turned);
}

void add_turned_from_axis(int degree, const AxisTurn& axis, const Lanes& factor,
                          const Lanes* turned, Lanes* sums) {
  const double* matrix = axis.tables.exchange(degree);
  if (degree <= unrolled_degrees)
    return unrolled_from_axis[static_cast<std::size_t>(degree)](matrix, axis, factor, turned, sums);
  DegreeLanes first, second;
  exchange_by_loops(degree, matrix, turned, first.data());
  turn_back(degree, axis.polar, first.data(), second.data());
  exchange_by_loops(degree, matrix, second.data(), first.data());
  turn_back(degree, axis.azimuth, first.data(), second.data());
  for (int i = 0; i <= 2 * degree; ++i) sums[i] += factor * second[static_cast<std::size_t>(i)];
}

}  // namespace mote
