#pragma once

#include <memory>
#include <utility>

#include "mote/integrators/velocity_verlet.hpp"
#include "mote/models/weakly_compressible.hpp"
#include "mote/operators/differential/corrected_sph.hpp"
#include "support/space_case.hpp"

namespace mote::test {

/// A weakly compressible fluid.
struct FlowCase : SpaceCase {
  WeaklyCompressibleOptions options{.sound_speed = 10};
};

inline FlowCase flow_in_a_box(int dimension, double spacing, const Triple& upper,
                              const std::array<bool, 3>& periodic = {}) {
  return fluid_in_a_box<FlowCase>(dimension, spacing, upper, periodic);
}

/// Without a free surface and density diffusion.
inline FlowCase periodic_square(double spacing, double width) {
  FlowCase flow = flow_in_a_box(2, spacing, {width, width}, {true, true, false});
  flow.options.free_surface = false;
  flow.options.diffusion = DensityDiffusion::none;
  return flow;
}

template <int D>
std::unique_ptr<WeaklyCompressible<D>> make_flow(const FlowCase& flow) {
  SpaceSetup setup = setup_of<D>(flow);
  auto made = std::make_unique<CorrectedSph<D, WendlandC2<D>>>();
  made->smoothing_length = flow.smoothing_length;
  setup.differential_operator = std::move(made);
  return std::make_unique<WeaklyCompressible<D>>(flow.options, std::move(setup));
}

/// One step, as a run takes it.
template <int D>
void step_once(WeaklyCompressible<D>& flow, Integrator& integrator, double time, double step) {
  flow.longest_step(time, 0.2);
  flow.begin_step(time, step);
  integrator.advance_one_step(flow, time, step);
  flow.end_step(time, step);
  flow.update_dependent_fields();
}

template <int D>
void run(WeaklyCompressible<D>& flow, double end, int steps, double start = 0) {
  VelocityVerlet integrator;
  flow.start_afresh();
  const double step = (end - start) / steps;
  for (int k = 0; k < steps; ++k) step_once(flow, integrator, start + k * step, step);
}

/// Rates of the state as it is.
template <int D>
void update_rates(WeaklyCompressible<D>& flow, double time = 0) {
  flow.prepare(time);
  flow.update_kick_rates(time);
}

/// Acceleration of particle i, by the last rates.
template <int D>
Vec<D> acceleration_of(WeaklyCompressible<D>& flow, Index i) {
  return Vec<D>::Map(flow.kicked()[0].rate.data() + std::ptrdiff_t{i} * D);
}

}  // namespace mote::test
