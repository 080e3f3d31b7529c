#pragma once

#include <complex>
#include <span>

namespace mote {

/// Divided difference exp[x1; ...; xk] of the exponential function over any number of nodes, in any
/// order, repeated or close together: Nadukandi 2014, (31)-(33).
///
/// Real nodes: by the Taylor series about the smallest, which has positive terms only, and where
/// nodes are far apart by the recurrence (32), which then cancels nothing. Relative error at most
/// 1e-14 for five nodes between -50 and 50.
///
/// Complex nodes: by the series of the exponential of a bidiagonal matrix, scaled and squared
/// (McCurdy, Ng and Parlett 1984). The value may vanish; the error is relative to exp[real parts].
///
/// In long double the error is below the rounding of the result to double. Throws
/// std::invalid_argument for no nodes, or more than five.
template <typename Real>
Real exponential_difference(std::span<const Real> nodes);

template <typename Real>
std::complex<Real> exponential_difference(std::span<const std::complex<Real>> nodes);

}  // namespace mote
