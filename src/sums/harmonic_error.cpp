#include "mote/sums/harmonic_error.hpp"

#include <cmath>

namespace mote {

// The part of 1/|d + x - y| of degree n in y and l in x is at most C(n+l, n) a^n b^l/d^(n+l+1), its
// value for x and y along d towards each other: in axes along d it is the sum over orders m of
// +- sqrt(C(n+l, n-m) C(n+l, n+m)) S_n^m(y) S_l^m(x), whose factors are largest for m = 0, and the
// sum over m of S_n^m(y)^2 is 1. The terms left out are those of n > p and those of l > p:
//   sum_(n>p) sum_l C(n+l, n) a^n b^l = sum_(n>p) a^n/(1-b)^(n+1) = q^(p+1)/(1 - a - b).
// The gradient of a homogeneous polynomial of degree l on a ball is at most l times its largest
// value over the radius (Kellogg), so its bound is the derivative with respect to b.

double potential_error_bound(const PairRatios& ratios, int degree) {
  const auto [a, b] = ratios;
  return (std::pow(a / (1 - b), degree + 1) + std::pow(b / (1 - a), degree + 1)) / (1 - a - b);
}

double gradient_error_bound(const PairRatios& ratios, int degree) {
  const auto [a, b] = ratios;
  const double q = a / (1 - b), t = b / (1 - a), apart = 1 - a - b, p = degree;
  const double of_source = std::pow(q, p + 1) * ((p + 2) - (p + 1) * q) / (apart * apart);
  const double of_target = std::pow(t, p) * ((p + 1) - p * t) / (apart * apart);
  return of_source + of_target;
}

int degree_for(const PairRatios& ratios, double tolerance) {
  const auto [a, b] = ratios;
  const double apart = 1 - a - b;
  if (apart <= 0) return highest_degree + 1;
  const double q = a / (1 - b), t = b / (1 - a), limit = tolerance * apart;
  double of_source = q, of_target = t;
  int degree = 0;
  for (; degree <= highest_degree && of_source + of_target > limit; ++degree) {
    of_source *= q;
    of_target *= t;
  }
  return degree;
}

}  // namespace mote
