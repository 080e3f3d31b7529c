#pragma once

#include <array>

namespace mote {

/// The largest distance between an orbit and its Hermite polynomials.
struct InterpolationError {
  double position, velocity;
};

/// One error for each of `Paths`, in their order.
using InterpolationErrors = std::array<InterpolationError, 4>;

/// Errors of Hermite interpolation of the Kepler problem (mu = a = 1) over one period from
/// pericentre, divided into equal sub-intervals (at least 3) with exact nodes between them, sampled
/// at every tenth of each. A polynomial over more than one sub-interval is used in the last of
/// them, and the first one also before that. (Rehman 2014, Table 2 and Figure 1; the table's
/// numbers corrected: times 100.) Throws std::domain_error for an eccentricity not in [0, 1).
InterpolationErrors kepler_interpolation_errors(double eccentricity, int sub_intervals);

}  // namespace mote
