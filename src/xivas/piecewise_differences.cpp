#include "mote/xivas/piecewise_differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace mote {
namespace {

using Complex = std::complex<double>;

template <typename T>
T sinhc(T x) {
  return x == T(0) ? T(1) : std::sinh(x) / x;
}

double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

/// (106): to rounding, for two nodes of any distance.
template <typename T>
T of_two(T x1, T x2) {
  return std::exp((x1 + x2) / 2.0) * sinhc((x2 - x1) / 2.0);
}

double q(double x) { return of_two(0.0, x); }

/// The series (116) about the mean of three nodes.
template <typename T>
T series_of_three(T x1, T x2, T x3, int terms) {
  const T mean = (x1 + x2 + x3) / 3.0;
  const T d1 = x1 - mean, d2 = x2 - mean, d3 = x3 - mean;
  const T variance = (d1 * d1 + d2 * d2 + d3 * d3) / 3.0, triple = d1 * d2 * d3;
  const std::array<T, 4> term{T(1), variance / 8.0, triple / 60.0, variance * variance / 160.0};
  T sum = 0;
  for (int n = 0; n < terms; ++n) sum += term[static_cast<std::size_t>(n)];
  return std::exp(mean) / 2.0 * sum;
}

/// Four terms of (99) for four or five nodes; pairs, triples and quadruples are the sums of the
/// products of two, three and four deviations from the mean. Summed from the smallest term on, and
/// the exponential taken last, Tables 3 and 5 come out in all digits that are right there.
struct Combinations {
  double pairs, triples, quadruples;
};

double series_of_four(double mean, const Combinations& of) {
  const double last = (of.pairs * of.pairs - of.quadruples) / 840;
  return std::exp(mean) * ((1 + (-of.pairs / 20 + (of.triples / 120 + last))) / 6);
}

double series_of_five(double mean, const Combinations& of) {
  const double last = (of.pairs * of.pairs - of.quadruples) / 1680;
  return std::exp(mean) * ((1 + (-of.pairs / 30 + (of.triples / 210 + last))) / 24);
}

/// (95)-(97), from the product of (1 + s d) over all deviations d.
Combinations combinations(std::span<const double> nodes, double mean) {
  std::array<double, 5> power{1};
  for (const double node : nodes)
    for (std::size_t n = 4; n > 0; --n) power[n] += power[n - 1] * (node - mean);
  return {power[2], power[3], power[4]};
}

double mean_of(std::span<const double> nodes) {
  double sum = 0;
  for (const double node : nodes) sum += node;
  return sum / static_cast<double>(nodes.size());
}

/// (130), nodes ascending.
double of_three(std::span<const double> x, int terms) {
  static constexpr std::array<int, 5> threshold{0, 16, 12, 9, 7};  // (126)-(129)
  const double spread = x[2] - x[0];
  if (spread > std::ldexp(1, -threshold[static_cast<std::size_t>(terms)]))
    return std::exp(x[1]) * (q(x[2] - x[1]) - q(x[0] - x[1])) / spread;
  return series_of_three(x[0], x[1], x[2], terms);
}

/// (142) and (152), nodes ascending.
double of_many(std::span<const double> x) {
  if (x.size() == 3) return of_three(x, 4);
  const bool four = x.size() == 4;
  const double spread = x.back() - x.front(), mean = mean_of(x);
  if (spread > (four ? 0x1p-6 : 0x1p-4))
    return (of_many(x.last(x.size() - 1)) - of_many(x.first(x.size() - 1))) / spread;
  return four ? series_of_four(mean, combinations(x, mean))
              : series_of_five(mean, combinations(x, mean));
}

/// exp[iy; x1; x2], (161).
Complex half_pair_of_two(double y, double x1, double x2) {
  const Complex i_y{0, y}, z2{x2, y};
  if (std::abs(z2) > 0x1p-7) return (of_two(x1, x2) - of_two(i_y, Complex(x1))) / std::conj(z2);
  return series_of_three(i_y, Complex(x1), Complex(x2), 4);
}

/// (135).
double pair_of_one(double y, double x) {
  const Complex z{x, y};
  if (std::abs(z) > 0x1p-7) return ((of_two(Complex(0, y), Complex(x)) - sinc(y)) / z).real();
  return series_of_three(Complex(0, -y), Complex(0, y), Complex(x), 4).real();
}

/// (148), |x1| <= |x2|.
double pair_of_two(double y, double x1, double x2) {
  const Complex z2{x2, y};
  if (std::abs(z2) > 0x1p-6) {
    const Complex difference = of_two(x1, x2) - of_two(Complex(0, y), Complex(x1));
    return ((difference / std::conj(z2) - pair_of_one(y, x1)) / z2).real();
  }
  const double mean = (x1 + x2) / 4, square = mean * mean;
  return series_of_four(mean,
                        {y * y + x1 * x2 - 6 * square, 2 * mean * (y * y - x1 * x2 + 4 * square),
                         (y * y + square) * (x1 * x2 - 3 * square)});
}

/// (158); the sign of the last term of its series as there and not as in (179).
double pair_of_three(double y, std::span<const double> x) {
  const Complex z3{x[2], y};
  if (std::abs(z3) > 0x1p-4) {
    std::array<double, 3> ascending{x[0], x[1], x[2]};
    std::ranges::sort(ascending);
    const Complex difference = of_three(ascending, 4) - half_pair_of_two(y, x[0], x[1]);
    return ((difference / std::conj(z3) - pair_of_two(y, x[0], x[1])) / z3).real();
  }
  const double mean = (x[0] + x[1] + x[2]) / 5, square = mean * mean;
  const double squares = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], product = x[0] * x[1] * x[2];
  return series_of_five(mean,
                        {(2 * y * y + 5 * square - squares) / 2,
                         mean / 2 * (4 * y * y - 35 * square + 3 * squares) + product,
                         6 * square * square + (11 * square - squares) * (y * y + 3 * square) / 2 -
                             2 * mean * product});
}

/// (54) as it stands, for (x, y) other than (0, 0).
double usual_phi(double x, double y) {
  return (std::exp(x) - std::cos(y) - x * sinc(y)) / (x * x + y * y);
}

}  // namespace

double piecewise_difference(std::span<const double> nodes, int terms) {
  if (nodes.empty() || nodes.size() > 5 || terms < 1 || terms > 4)
    throw std::invalid_argument("one to five nodes, and one to four terms");
  std::array<double, 5> kept;
  const std::span<double> x(kept.data(), nodes.size());
  std::ranges::copy(nodes, x.begin());
  std::ranges::sort(x);
  if (x.size() == 1) return std::exp(x[0]);
  if (x.size() == 2) return of_two(x[0], x[1]);
  return x.size() == 3 ? of_three(x, terms) : of_many(x);
}

double piecewise_pair_difference(double y, std::span<const double> nodes) {
  if (nodes.size() > 3) throw std::invalid_argument("at most three nodes beside the pair");
  std::array<double, 3> kept;
  const std::span<double> x(kept.data(), nodes.size());
  std::ranges::copy(nodes, x.begin());
  std::ranges::stable_sort(x, {}, [](double value) { return std::abs(value); });
  if (x.empty()) return sinc(y);
  if (x.size() == 1) return pair_of_one(y, x[0]);
  return x.size() == 2 ? pair_of_two(y, x[0], x[1]) : pair_of_three(y, x);
}

double recursive_difference(double x1, double x2, double x3) {
  const double upper = (std::exp(x3) - std::exp(x2)) / (x3 - x2);
  return (upper - (std::exp(x2) - std::exp(x1)) / (x2 - x1)) / (x3 - x1);
}

double collected_difference(double x1, double x2, double x3) {
  return std::exp(x1) / ((x1 - x2) * (x1 - x3)) + std::exp(x2) / ((x2 - x1) * (x2 - x3)) +
         std::exp(x3) / ((x3 - x1) * (x3 - x2));
}

double usual_r_difference(double x1, double x2, double x3) {
  const auto r = [](double x) { return (q(x) - 1) / x; };
  const double lower = (r(x2) - r(x1)) / (x2 - x1), upper = (r(x3) - r(x2)) / (x3 - x2);
  return (upper - lower) / (x3 - x1);
}

/// (192), and (191) corrected: Upsilon(-x, y) has e^x.
double usual_pair_difference(double x, double y, double l) {
  const double phi = usual_phi(-x, y), growth = std::exp(x);
  const double upsilon = (1 - growth * (sinc(y) - 2 * x * phi)) / (x * x + y * y);
  const double r = (std::exp(l) - 1 - l) / (l * l);
  const double d = l - x;
  return (r - (l - 2 * x) * upsilon - growth * phi) / ((d * d + y * y) * growth);
}

}  // namespace mote
