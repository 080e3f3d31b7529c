#include "mote/sums/translation_error.hpp"

#include <algorithm>
#include <cmath>

#include "mote/sums/lane_access.hpp"

namespace mote {
namespace {

/// Places in the row of numbers.
enum Place : std::size_t { strength, reach, monopole, others, higher_degrees };

/// The lowest degree that is taken, however large the errors may be: those of lower ones have a
/// common sign over many pairs.
constexpr int lowest = 3;

double power_of(double base, int exponent) {
  double power = 1;
  for (; exponent > 0; exponent /= 2, base *= base)
    if (exponent % 2 == 1) power *= base;
  return power;
}

/// first, first x, first x^2, ...
[[gnu::always_inline]] inline Lanes powers_from(double first, double x) {
  const double square = x * x, fourth = square * square;
  return first * Lanes([&](auto lane) { return lane & 1 ? x : 1.0; }) *
         Lanes([&](auto lane) { return lane & 2 ? square : 1.0; }) *
         Lanes([&](auto lane) { return lane & 4 ? fourth : 1.0; });
}

}  // namespace

std::size_t SourcePowers::count(int degree) {
  return higher_degrees + static_cast<std::size_t>(degree + 1) + lane_count;
}

void SourcePowers::take_points(const PointColumns& points, const NodeBall& ball,
                               const double* multipole) {
  double all = 0, moment = 0;
  for (std::size_t i = 0; i < points.count; ++i) {
    double of_point = 0, square = 0;
    for (const double* column : points.strengths) of_point += column[i] * column[i];
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = (points.position[d][i] - ball.centre[d]) / ball.radius;
      square += x * x;
    }
    of_point = std::sqrt(of_point);
    all += of_point;
    moment += of_point * power_of(std::sqrt(square), degree_ + 1);
  }
  take_highest(all, moment);
  take_expansion(multipole);
}

void SourcePowers::take_children(std::span<const Child> children, double radius,
                                 const double* multipole) {
  double all = 0, moment = 0;
  for (const auto& [numbers, child_radius, distance] : children) {
    const double longest = std::min(1.0, (numbers[reach] * child_radius + distance) / radius);
    all += numbers[strength];
    moment += numbers[strength] * power_of(longest, degree_ + 1);
  }
  take_highest(all, moment);
  take_expansion(multipole);
}

void SourcePowers::take_highest(double all, double moment) {
  numbers_[strength] = all;
  numbers_[reach] = all > 0 ? std::pow(moment / all, 1.0 / (degree_ + 1)) : 0;
}

void SourcePowers::take_expansion(const double* multipole) {
  double largest = 0, higher = 0;
  for (int n = degree_; n >= 0; --n) {
    numbers_[higher_degrees + static_cast<std::size_t>(n)] = higher;
    double square = 0;
    for (int c = 0; c < components_; ++c) {
      const double* of_degree =
          multipole + static_cast<std::size_t>(c) * harmonic_count(degree_) + cosine_place(n, 0);
      for (int i = 0; i <= 2 * n; ++i) square += of_degree[i] * of_degree[i];
    }
    const double power = std::sqrt(square);
    if (n == 0) numbers_[monopole] = power;
    if (n > 0) largest = std::max(largest, power);
    higher = power + largest_ratio * (n + 3.0) / (n + 1.0) * higher;
  }
  numbers_[others] = largest;
}

bool are_too_near(const PairOfBalls& pair) {
  const auto [a, b, d] = pair;
  return !(a <= largest_ratio * (d - b) && b <= largest_ratio * (d - a));
}

TranslationErrors::TranslationErrors(const double* powers, int degree, const PairOfBalls& pair)
    : powers_(powers), degree_(degree), pair_(pair) {
  const auto [a, b, d] = pair;
  inverse_gap_ = 1 / (d - b);
  const double q = a * inverse_gap_;
  beyond_ = powers[strength] * power_of(powers[reach] * q, degree + 1) / (1 - q) * inverse_gap_;
}

// With radii a and b, d apart, the part of degree n in the source and l in the target is at most
// C(n+l, n) P_n a^n b^l/d^(n+l+1) (see harmonic_error.cpp, where P_n is the sum of all strengths).
// Terms left out, with q = a/(d - b), t = b/d, u = b/(d - a), k = degree + 1:
//   n > p:  sum_n P_n a^n/(d - b)^(n+1)
//             <= (sum_(n>p) P_n w^(n-p-1) q^(p+1) + M (s q)^k/(1 - q))/(d - b)
//   l > p:  sum_l t^l P_0/d + sum_(n>0) sum_(l>p) C(n+l, n) P_n a^n b^l/d^(n+l+1)
//             <= P_0 t^(p+1)/(d - b) + (largest P_n) u^(p+1)/(d - a - b).
// Each derivative multiplies a term of degree l by l/b at most (Kellogg). With ratios up to 0.6
// that is p + 3 times the second sum over b, and for the first p + 3 or k + 4 times it over d - b.
std::array<Lanes, 3> TranslationErrors::from_degree(int first) const {
  const auto [a, b, d] = pair_;
  const double q = a * inverse_gap_, t = b / d, u = b / (d - a), inverse_radius = 1 / b;
  const Lanes degree([first](auto i) { return static_cast<double>(first) + i; });
  const Lanes higher = load(powers_ + higher_degrees + first) *
                       powers_from(power_of(q, first + 1) * inverse_gap_, q);
  Lanes target = powers_from(powers_[monopole] * power_of(t, first + 1) * inverse_gap_, t) +
                 powers_from(powers_[others] * power_of(u, first + 1) / (d - a - b), u);
  Lanes source = higher;
  double beyond = beyond_;
  std::array<Lanes, 3> errors;
  for (Lanes& error : errors) {
    error = source + beyond + target;
    source *= (degree + 3) * inverse_gap_;
    beyond *= (degree_ + 5) * inverse_gap_;
    target *= (degree + 3) * inverse_radius;
  }
  return errors;
}

[[gnu::flatten]] int TranslationErrors::lowest_degree(const FarErrors& allowed) const {
  for (int first = lowest; first <= degree_; first += static_cast<int>(lane_count)) {
    const auto errors = from_degree(first);
    const auto fits = errors[0] <= allowed[0] && errors[1] <= allowed[1] && errors[2] <= allowed[2];
    if (any_of(fits)) return std::min(first + find_first_set(fits), degree_ + 1);
  }
  return degree_ + 1;
}

}  // namespace mote
