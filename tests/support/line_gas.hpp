#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <utility>

#include "mote/integrators/integrator.hpp"
#include "mote/models/pressureless_gas.hpp"
#include "mote/operators/differential/all.hpp"
#include "mote/operators/kernels/all.hpp"

namespace mote::test {

/// A gas on a line as a scenario would give it: fields at the start as functions of the place.
struct LineGas {
  std::string name;
  double gravity;
  std::function<double(double x)> density;
  std::function<double(double x)> velocity = [](double) { return 0.0; };
  double upper = 4;
  LineEnds ends = LineEnds::zero_gradient;

  friend void PrintTo(const LineGas& gas, std::ostream* out) { *out << gas.name; }
};

/// The three cases of Isshiki (2014), section 6.3.1, as in scenarios/gravity.
inline LineGas trapezoid() {
  return {"trapezoid", 0.0015, [](double x) {
            return 0.025 + std::clamp(std::min(10 * (x / 4 - 0.25), 10 * (0.75 - x / 4)), 0.0, 1.0);
          }};
}
inline LineGas rectangle() {
  return {"rectangle", 0.001, [](double x) { return x >= 1 && x <= 3 ? 1.5 : 0.5; }};
}
/// (88): two streams of unit density, 0.5 and -0.5 fast, with a slope between them.
inline LineGas flat_slope_flat() {
  return {"flat_slope_flat",
          0,
          [](double) { return 1.0; },
          [](double x) { return std::clamp(1 - x / 2, -0.5, 0.5); },
          4,
          LineEnds::held};
}
/// (83): a cloud of exponential density.
inline LineGas exponential() {
  return {"exponential", 0.005, [](double x) { return std::exp(-std::pow((x - 2) / 0.8, 2)); }};
}
inline LineGas slab() {
  return {"slab", 0.0015, [](double x) { return x >= 0.35 * 4 && x < 0.75 * 4 ? 1.025 : 0.025; }};
}

/// An operator as a scenario makes it: with as many cells beyond each end as it reaches.
using OperatorOnALine = std::unique_ptr<DifferentialOperator<1>>;

inline OperatorOnALine sph_gauss() { return std::make_unique<Sph<1, Gauss<1>>>(); }

template <class Layout>
PressurelessGas make_gas(const LineGas& gas, const PressurelessGasOptions& options, Index count,
                         OperatorOnALine op, std::uint64_t seed = 0) {
  LineSetup setup;
  setup.upper = gas.upper;
  setup.cells = cells_of_line<Layout>(0, gas.upper, count, seed);
  setup.ends = gas.ends;
  setup.extension = static_cast<std::int64_t>(std::ceil(op->neighbour_rule().reach()));
  setup.initial = [gas](std::string_view field, double x) {
    return field == "density" ? gas.density(x) : gas.velocity(x);
  };
  setup.differential_operator = std::move(op);
  return PressurelessGas(options, std::move(setup));
}

/// The gas on regular cells.
inline PressurelessGas make_gas(const LineGas& gas, const PressurelessGasOptions& options,
                                Index count, OperatorOnALine op = sph_gauss()) {
  return make_gas<Regular>(gas, options, count, std::move(op));
}

/// One step, with what the model does before and after it.
inline void step_once(PressurelessGas& gas, Integrator& integrator, double time, double step) {
  gas.begin_step(time, step);
  integrator.advance_one_step(gas, time, step);
  gas.end_step(time, step);
  gas.update_dependent_fields();
}

/// Takes `steps` equal steps from time 0 to `end`, with a snapshot after each tenth.
inline void run(PressurelessGas& gas, Integrator& integrator, double end, int steps) {
  const double step = end / steps;
  for (int k = 0; k < steps; ++k) {
    if (k % std::max(1, steps / 10) == 0) integrator.forget_rounding();
    step_once(gas, integrator, k * step, step);
  }
}

}  // namespace mote::test
