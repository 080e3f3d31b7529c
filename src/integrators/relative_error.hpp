#pragma once

#include <span>

#include "mote/integrators/kept_values.hpp"
#include "mote/integrators/stages.hpp"
#include "mote/integrators/system.hpp"

namespace mote {

/// The largest of |value|; infinite if one is not finite.
double largest_magnitude(std::span<const double> values);

/// The largest of |step * rate| in a part over the largest of the part's values, here or at the
/// start of the step; the largest of all parts. `rates` hold the values here and the rates of some
/// error. Infinite if something is not finite.
double relative_error(const KeptValues& start, std::span<const Evolving> rates, double step);

/// The same where the rates are sum_s weight[s] * rate of stage s.
double relative_error(Stages& stages, std::span<const double> weights, double step);

}  // namespace mote
