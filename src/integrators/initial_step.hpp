#pragma once

#include "mote/integrators/system.hpp"

namespace mote {

/// A length for the first step of a method whose error, relative to the largest value of its kind,
/// goes with the power `power` of the step and is to be `tolerance`: from the rates at the start
/// and after a small step of Euler's, and so the first and second derivatives (Hairer, Norsett and
/// Wanner 1993, section II.4; here derivatives enter as times, so that the result does not depend
/// on the unit of time). Leaves the system's values as they were.
double initial_step(System& system, double time, double tolerance, int power);

}  // namespace mote
