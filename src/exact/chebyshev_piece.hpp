#pragma once

#include <array>
#include <functional>

namespace mote {

/// A function on a piece of the line as a Chebyshev series, and the integral of the series. The
/// coefficients come from the function in double precision; they are kept, and the integral is
/// summed, in long double, because it is later divided by a viscosity that may be small.
struct ChebyshevPiece {
  static constexpr int degree = 15;
  template <class Real>
  using Series = std::array<Real, degree + 2>;

  double lower, upper;
  int highest = 0;            ///< degree of the last coefficient that is not rounding
  Series<double> value{};     ///< coefficients of the function
  Series<long double> sum{};  ///< of its integral from `lower`, in the same variable
  long double before = 0;     ///< integral up to `lower`
  bool resolved = false;      ///< whether the series is the function to rounding
  long double sum_in_the_middle = 0;
  double largest = 0;  ///< magnitude of the function, by samples

  /// The interpolant at the 16 Chebyshev points of (lower, upper); the ends are not touched. It is
  /// resolved if its last coefficients, and what it differs by at `checks` more places, are
  /// rounding: 4e-15 of `scale`, or of the function if that is larger, and what a rounding of the
  /// place makes. Throws std::invalid_argument where the function is not a finite number.
  ChebyshevPiece(const std::function<double(double)>& function, double lower, double upper,
                 double scale, int checks);

  /// The polynomial at a place, beyond the piece too.
  double operator()(double place) const;

  /// The integral up to a place in the piece.
  long double integral(long double place) const;

  /// A bound from below of the integral in the piece; samples are trusted to miss less than a tenth
  /// of the largest magnitude.
  long double lowest_integral() const {
    return before + sum_in_the_middle - 0.55L * largest * (upper - lower);
  }
};

}  // namespace mote
