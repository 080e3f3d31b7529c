#pragma once

#include <array>

namespace mote {

/// A function and its first two derivatives at a place.
struct Jet {
  double value = 0, slope = 0, bend = 0;
};

/// How a wave function is made of polynomials: as it is, or, of the distance r from a centre, as r
/// times a polynomial, so that a potential in 1/r times it is a polynomial too.
enum class WaveForm { plain, radial };

/// An interval of the line, whose wave functions are cubics, or r times cubics, of the values and
/// slopes at its ends, equations (4.2.2) and (4.4.5).
struct WaveInterval {
  WaveForm form;
  double lower, upper;

  /// The functions whose value at the lower end, slope there, value at the upper end, and slope
  /// there is 1 and the others 0. From r = 0 on, where the value is 0, they are r times quadratics
  /// (4.4.11).
  std::array<Jet, 4> functions(double x) const;
};

/// What a wave function does beyond an end of the domain: its value there times
///   e^-k|x - end|,   or for the radial form (r/end) e^-k(r - end),
/// equations (4.3.3) and, with k = 1/end, (4.4.5).
struct WaveTail {
  WaveForm form;
  double end, direction;  ///< direction: 1 above the domain, -1 below
  double decay;           ///< k

  /// The function without its exponential, so that it and the decay give all derivatives.
  Jet factor(double distance) const;
  Jet function(double distance) const;
};

}  // namespace mote
