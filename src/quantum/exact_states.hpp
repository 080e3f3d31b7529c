#pragma once

#include <functional>

namespace mote {

/// Stationary states in closed form, the lowest first, numbered from 0. Wave functions are
/// normalised, and positive at first from below.
struct ExactStates {
  std::function<double(int state)> energy;
  std::function<double(int state, double x)> wave_function;
};

/// Between walls: E = (n pi/l)^2, psi = sqrt(2/l) sin(n pi (x - lower)/l), n = state + 1, (4.1.2).
ExactStates well_states(double lower, double upper);

/// V = x^2: E = 2 state + 1, and the Hermite functions.
ExactStates oscillator_states();

/// V = -2/r without angular momentum: E = -1/n^2, psi = 2 n^(-5/2) r e^(-r/n) L(2r/n), n = state +
/// 1, with the associated Laguerre polynomial L of degree n - 1 and order 1; (4.4.3) for n = 1.
ExactStates coulomb_states();

}  // namespace mote
