#include "mote/quantum/exact_states.hpp"

#include <cmath>
#include <numbers>

namespace mote {
namespace {

using std::numbers::pi;

/// h_0 = pi^(-1/4) e^(-x^2/2),  h_(k+1) = sqrt(2/(k+1)) x h_k - sqrt(k/(k+1)) h_(k-1).
double hermite_function(int degree, double x) {
  double before = 0, value = std::exp(-x * x / 2) / std::pow(pi, 0.25);
  for (int k = 0; k < degree; ++k) {
    const double next = std::sqrt(2.0 / (k + 1)) * x * value - std::sqrt(k / (k + 1.0)) * before;
    before = value;
    value = next;
  }
  return value;
}

}  // namespace

ExactStates well_states(double lower, double upper) {
  const double length = upper - lower;
  return {.energy = [=](int state) { return std::pow((state + 1) * pi / length, 2); },
          .wave_function =
              [=](int state, double x) {
                if (x < lower || x > upper) return 0.0;
                return std::sqrt(2 / length) * std::sin((state + 1) * pi * (x - lower) / length);
              }};
}

ExactStates oscillator_states() {
  return {.energy = [](int state) { return 2.0 * state + 1; },
          .wave_function = [](int state, double x) { return hermite_function(state, -x); }};
}

ExactStates coulomb_states() {
  return {.energy = [](int state) { return -1 / std::pow(state + 1, 2); },
          .wave_function =
              [](int state, double r) {
                const double n = state + 1;
                const double laguerre =
                    std::assoc_laguerre(static_cast<unsigned>(state), 1, 2 * r / n);
                return 2 * std::pow(n, -2.5) * r * std::exp(-r / n) * laguerre;
              }};
}

}  // namespace mote
