#pragma once

#include <array>
#include <span>

#include "mote/particles/vector.hpp"

namespace mote {

/// A piece of a streamline of a linear field, dx/dt = v + A (x - x0) from x0 on: x - x0 = Q(t) v by
/// its Taylor series, in the part s = t / duration of its time, between 0 and 1.
template <int D>
class LinearPath {
 public:
  static constexpr int most_terms = 20;
  using Polynomial = std::array<double, most_terms + 1>;  ///< coefficients of s^0, s^1, ...

  /// Takes as much of the time as the series serves well: |A| duration is at most 1, and
  /// |v| duration at most this length.
  LinearPath(const Mat<D>& gradient, const Vec<D>& velocity, double time, double length);

  double duration() const { return duration_; }
  int terms() const { return terms_; }  ///< of the polynomials: coefficients after that are zero

  /// x - x0, and the integral of it over the time so far, R(t) v.
  Vec<D> displacement(double part) const;
  Vec<D> integral(double part) const;

  /// Of normal.(x - x0) + start.
  Polynomial along(const Vec<D>& normal, double start) const;

 private:
  double duration_;
  int terms_ = 0;
  std::array<Vec<D>, most_terms> term_;  ///< of s, s^2, ...
};

/// The first part of the time, at most `end`, at which a polynomial comes to between half of
/// `limit` and `limit`; 0 if it starts above; `end` or more if it never comes there. The search
/// goes forward in steps within which the value surely stays below `limit`, as the coefficients
/// bound the second derivative. Near a crossing they are Newton's steps, and the crossing is never
/// passed.
double first_crossing(std::span<const double> polynomial, double limit, double end);

extern template class LinearPath<2>;
extern template class LinearPath<3>;

}  // namespace mote
