#include "mote/sums/harmonic_field.hpp"

#include <algorithm>

#include "mote/sums/solid_harmonics.hpp"

namespace mote {
namespace {

/// d/dx of harmonics goes to the next orders on either side, a cosine to cosines.
void add_slope_along_x(int n, double factor, const double* in, double* out) {
  const HarmonicTables& tables = harmonic_tables();
  for (int m = 0; m < n; ++m) {
    double even = tables.below(n, m + 1) * in[m + 1];
    if (m > 0) even += tables.above(n, m - 1) * in[m - 1];
    out[m] += factor * even;
    if (m == 0) continue;
    double odd = tables.below(n, m + 1) * in[n + m + 1];
    if (m > 1) odd += tables.above(n, m - 1) * in[n + m - 1];
    out[n - 1 + m] += factor * odd;
  }
}

/// d/dy goes to the same orders, a cosine to sines.
void add_slope_along_y(int n, double factor, const double* in, double* out) {
  const HarmonicTables& tables = harmonic_tables();
  for (int m = 0; m < n; ++m) {
    double even = tables.below(n, m + 1) * in[n + m + 1];
    if (m > 1) even -= tables.above(n, m - 1) * in[n + m - 1];
    out[m] += factor * even;
    if (m == 0) continue;
    const double odd = tables.above(n, m - 1) * in[m - 1] - tables.below(n, m + 1) * in[m + 1];
    out[n - 1 + m] += factor * odd;
  }
}

void add_slope_along_z(int n, double factor, const double* in, double* out) {
  const HarmonicTables& tables = harmonic_tables();
  for (int m = 0; m < n; ++m) {
    const double along = factor * tables.along(n, m);
    out[m] += along * in[m];
    if (m > 0) out[n - 1 + m] += along * in[n + m];
  }
}

std::array<Lanes, 3> in_units_of(const NodeBall& ball, const std::array<Lanes, 3>& point) {
  return {(point[0] - ball.centre[0]) / ball.radius, (point[1] - ball.centre[1]) / ball.radius,
          (point[2] - ball.centre[2]) / ball.radius};
}

/// even and odd += coefficients of one order times R of all degrees, the two recurrences of R at
/// once (see HarmonicTables::rise).
template <int functions, bool sines>
[[gnu::always_inline]] inline void sum_order(const std::array<double, functions>* coefficients,
                                             const double* rise, const double* fall,
                                             std::size_t degrees, const Lanes& z,
                                             const Lanes& squared, Lanes* even, Lanes* odd) {
  Lanes last = 0, value = 1;
  for (std::size_t i = 0; i < degrees; ++i) {
    for (std::size_t f = 0; f < functions; ++f) {
      even[f] += coefficients[i][f] * value;
      if constexpr (sines) odd[f] += coefficients[degrees + i][f] * value;
    }
    const Lanes next = rise[i + 1] * z * value - fall[i + 1] * squared * last;
    last = value;
    value = next;
  }
}

}  // namespace

void add_derivative(int degree, int axis, double factor, const double* local, double* derivative) {
  constexpr std::array along{&add_slope_along_x, &add_slope_along_y, &add_slope_along_z};
  for (int n = 1; n <= degree; ++n)
    along[static_cast<std::size_t>(axis)](n, factor, local + cosine_place(n, 0),
                                          derivative + cosine_place(n - 1, 0));
}

template <int functions>
HarmonicFunctions<functions>::HarmonicFunctions(int degree)
    : degree_(degree), coefficients_(harmonic_count(degree)) {}

template <int functions>
void HarmonicFunctions<functions>::put(int number, int degree, const double* expansion) {
  const auto f = static_cast<std::size_t>(number);
  for (int m = 0; m <= degree; ++m)
    for (int n = m; n <= degree; ++n) {
      const std::size_t place = by_order(degree_, m) + static_cast<std::size_t>(n - m);
      coefficients_[place][f] = expansion[cosine_place(n, m)];
      if (m > 0) coefficients_[place + degrees_of(degree_, m)][f] = expansion[sine_place(n, m)];
    }
}

template <int functions>
std::array<Lanes, functions> HarmonicFunctions<functions>::at(
    const std::array<Lanes, 3>& place) const {
  const HarmonicTables& tables = harmonic_tables();
  const auto& [x, y, z] = place;
  const Lanes squared = x * x + y * y + z * z;
  std::array<Lanes, functions> sums{};
  sum_order<functions, false>(coefficients_.data(), tables.rise(0), tables.fall(0),
                              degrees_of(degree_, 0), z, squared, sums.data(), nullptr);
  Lanes cosine = 1, sine = 0;
  for (int m = 1; m <= degree_; ++m) {
    const double first = tables.first(m);
    const Lanes turned = first * (x * cosine - y * sine);
    sine = first * (y * cosine + x * sine);
    cosine = turned;
    std::array<Lanes, functions> even{}, odd{};
    sum_order<functions, true>(&coefficients_[by_order(degree_, m)], tables.rise(m), tables.fall(m),
                               degrees_of(degree_, m), z, squared, even.data(), odd.data());
    for (std::size_t f = 0; f < functions; ++f) sums[f] += cosine * even[f] + sine * odd[f];
  }
  return sums;
}

template class HarmonicFunctions<3>;
template class HarmonicFunctions<4>;
template class HarmonicFunctions<12>;

PotentialField::PotentialField(int degree)
    : degree_(degree), slope_(harmonic_count(degree)), functions_(degree) {}

void PotentialField::prepare(const double* local, const NodeBall& ball) {
  ball_ = ball;
  functions_.put(0, degree_, local);
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::fill(slope_, 0.0);
    add_derivative(degree_, axis, 1 / ball.radius, local, slope_.data());
    functions_.put(1 + axis, degree_, slope_.data());
  }
}

std::array<Lanes, 4> PotentialField::at(const std::array<Lanes, 3>& point) const {
  return functions_.at(in_units_of(ball_, point));
}

CurlField::CurlField(int degree)
    : degree_(degree),
      curl_(3 * harmonic_count(degree)),
      slope_(harmonic_count(degree)),
      functions_(degree),
      functions_and_slopes_(degree) {}

void CurlField::prepare(const double* local, const NodeBall& ball, bool gradient) {
  ball_ = ball;
  std::ranges::fill(curl_, 0.0);
  const std::size_t size = harmonic_count(degree_);
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    double* curl = curl_.data() + static_cast<std::size_t>(a) * size;
    add_derivative(degree_, b, 1 / ball.radius, local + static_cast<std::size_t>(c) * size, curl);
    add_derivative(degree_, c, -1 / ball.radius, local + static_cast<std::size_t>(b) * size, curl);
    if (!gradient) {
      functions_.put(a, degree_, curl);
      continue;
    }
    functions_and_slopes_.put(a, degree_, curl);
    for (int axis = 0; axis < 3; ++axis) {
      std::ranges::fill(slope_, 0.0);
      add_derivative(degree_, axis, 1 / ball.radius, curl, slope_.data());
      functions_and_slopes_.put(3 + 3 * a + axis, degree_, slope_.data());
    }
  }
}

std::array<Lanes, 3> CurlField::at(const std::array<Lanes, 3>& point) const {
  return functions_.at(in_units_of(ball_, point));
}

std::array<Lanes, 12> CurlField::with_gradient(const std::array<Lanes, 3>& point) const {
  return functions_and_slopes_.at(in_units_of(ball_, point));
}

}  // namespace mote
