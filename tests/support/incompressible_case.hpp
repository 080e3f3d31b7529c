#pragma once

#include <memory>
#include <utility>

#include "mote/models/incompressible.hpp"
#include "mote/operators/differential/corrected_sph.hpp"
#include "mote/operators/differential/mps.hpp"
#include "support/space_case.hpp"

namespace mote::test {

/// An incompressible fluid as a scenario would give it.
struct IncompressibleCase : SpaceCase {
  IncompressibleOptions options;
  std::function<std::unique_ptr<AnyOperator>()> make_operator;
};

/// The case with this operator; walls and terms reach as far.
template <class Operator>
IncompressibleCase& with_operator(IncompressibleCase& flow, const Operator& op) {
  flow.make_operator = [op] { return std::make_unique<Operator>(op); };
  flow.plan.reach = op.neighbour_rule().reach();
  flow.smoothing_length = flow.plan.reach / 2;
  return flow;
}

/// Fluid in a box which is the domain as well, by corrected_sph.
template <int D>
IncompressibleCase incompressible_box(double spacing, const Triple& upper,
                                      const std::array<bool, 3>& periodic = {}) {
  auto flow = fluid_in_a_box<IncompressibleCase>(D, spacing, upper, periodic);
  CorrectedSph<D, WendlandC2<D>> op;
  op.smoothing_length = flow.smoothing_length;
  return with_operator(flow, op);
}

/// The same without a surface at which the pressure is 0.
inline IncompressibleCase& without_surface(IncompressibleCase& flow, double mean_pressure = 0) {
  flow.options.free_surface = false;
  flow.options.mean_pressure = mean_pressure;
  return flow;
}

/// Mps with the constants of a lattice, whose Laplacian is symmetric.
template <int D>
Mps<D> symmetric_mps(double smoothing_length = 3.1) {
  Mps<D> op;
  op.constants = MpsConstants::lattice;
  op.smoothing_length = smoothing_length;
  return op;
}

template <int D>
std::unique_ptr<Incompressible<D>> make_incompressible(const IncompressibleCase& flow) {
  SpaceSetup setup = setup_of<D>(flow);
  setup.differential_operator = flow.make_operator();
  return std::make_unique<Incompressible<D>>(flow.options, std::move(setup));
}

/// Steps of this length, as a run takes them.
template <int D>
void take_steps(Incompressible<D>& flow, int steps, double step, double start = 0) {
  flow.start_afresh();
  for (int k = 0; k < steps; ++k) {
    flow.end_step(start + k * step, step);
    flow.inspect();
  }
}

}  // namespace mote::test
